LISTING dmx-k-sa 4
0 GOSUB,3
1 SET,V1,1
2 SUB,2
3 SET,V1,2
;# for dmx-k-sa
;# error 2:1 There is no SUB 3
;# error 4:1 END is missing above: the program that begins in line 2
;# error 5:1 ENDSUB is missing below
