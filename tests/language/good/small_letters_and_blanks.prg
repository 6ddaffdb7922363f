hspd = 500
v1 = 5   % 3
if v1   >=   2
  x   v1
  waitx
  Delay=10
endif
While V1 < 4
  v1=v1+1
EndWhile
end
;# for pmx-4ex-sa dmx-k-sa
;# lines 15
;# after 100 V1=4 PX=2 state0=0 HSPD=500
