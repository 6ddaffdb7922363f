V1=5/0
V3=9
END
SUB 31
V2=7
ENDSUB
;# for pmx-4ex-sa dmx-k-sa
;# warning 1:6 division by zero
;# after 1 state0=1
;# after 50 V2=7 V3=0 state0=1 V1=0
