; kept from yesterday

listing pmx-4ex-sa 14
0 SET,DO,999
1 SET,JOYENA,V1
2 SET,DRVRC,1
3 MOVE,X,134217728
4 ARCP
5 +X,0
6 +Y,0
7 +TO,0,0
8 SET,DO1,5
9 SET,V1,7
10 SET,HSPDX,-1
11 SET,SYNCFGX,4
12 SET,DO,V1
13 END
;# for pmx-4ex-sa
;# error 4:1 DO takes 0 to 255
;# error 5:1 JOYENA takes only a number
;# error 6:1 means nothing
;# error 7:1 Positions are
;# error 8:1 swept angle
;# error 14:1 HSPDX takes 0 to 6,000,000
;# error 15:1 SYNCFGX takes 1 to 3
