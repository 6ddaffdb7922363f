GOSUB 1
END
SUB 1
V1=V1+1
GOSUB 1
ENDSUB
;# for pmx-4ex-sa dmx-k-sa
;# warning 1:1 in a circle
;# after 100 V1=8 state0=4 line0=5
