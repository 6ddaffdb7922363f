V1=5
V2=V1/V3
V4=1
END
;# for pmx-4ex-sa dmx-k-sa
;# after 50 V2=0 V4=0 state0=4 line0=2
