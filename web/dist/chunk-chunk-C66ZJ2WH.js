var e={clipped:1,dead:2,duplicate:4};export{e as a};
