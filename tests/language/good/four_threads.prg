PRG 0
X50
WAITX
V0=1
END
PRG 1
Y50
WAITY
V1=1
END
PRG 2
Z50
WAITZ
V2=1
END
PRG 3
U50
WAITU
V3=1
END
;# for pmx-4ex-sa
;# start 0 1 2 3
;# after 20 V0=0 V3=0 state3=1
;# after 100 V0=1 V1=1 V2=1 V3=1 state0=0 state3=0
