LISTING dmx-k-sa 4
0 SET,HSPD,1000
1 MOVE,X,1000
2 WAIT,X
;# for dmx-k-sa
;# error 6:1 It is not complete
