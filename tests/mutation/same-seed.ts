// The same random inputs for every mutant: what kills one must not be a matter of luck.
import fc from 'fast-check';

fc.configureGlobal({ ...fc.readConfigureGlobal(), seed: 1 });
