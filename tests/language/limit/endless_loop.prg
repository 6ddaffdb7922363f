PRG 0
WHILE 1=1
ENDWHILE
END
PRG 1
WHILE 1=1
  V1=V1+1
ENDWHILE
END
;# for pmx-4ex-sa dmx-k-sa
;# start 0 1
;# after 3000 state0=1 state1=1 V1=999..1001
