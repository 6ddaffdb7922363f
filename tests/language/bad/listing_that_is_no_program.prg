LISTING pmx-4ex-sa 8
0 IF,3
1 +TEST,V1,EQ,1,2
2 HELLO
3 ENDIF
5 END
5 +MOVE,X,1
6 SET,MSTX,1
7 GOSUB,99
;# for pmx-4ex-sa
;# error 2:1 names other lines
;# error 4:1 means nothing
;# error 6:1 Line 4 is expected here
;# error 7:1 means nothing
;# error 8:1 means nothing
;# error 9:1 means nothing
