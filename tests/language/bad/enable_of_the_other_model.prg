EO1=1
Y100
END
;# for dmx-k-sa
;# error 1:1 EO1 belongs to the PMX-4EX-SA
;# error 2:1 has one axis
