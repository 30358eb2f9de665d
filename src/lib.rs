#![no_std]
#![doc = "fixel"]
