
var e=e=>(`name`in e?String(e.name):``)||`model`;export{e as t};