V1=5
V2=V1%V3
V4=1
END
SUB 31
V3=3
ENDSUB
;# for pmx-4ex-sa dmx-k-sa
;# after 50 V2=2 V4=1 state0=0
