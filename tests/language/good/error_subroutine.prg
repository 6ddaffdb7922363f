X100
WAITX
V1=1
END
SUB 31
V2=V2+1
ECLEARX
ENDSUB
;# for pmx-4ex-sa dmx-k-sa
;# at 50 error0=1
;# after 49 V1=0
;# after 200 did:clear_X V2=1 V1=1 state0=0
