import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Adds up to three numbers, each multiplied by a gain. A negative gain subtracts. */
export const mix = defineProcessingModule({
  name: 'mix',
  description: 'Adds up to three numbers, each with a gain.',
  tags: ['number', 'sum', 'mixer'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    a: { format: 'double', description: 'First number; 0 without a value.' },
    b: { format: 'double', description: 'Second number; 0 without a value.' },
    c: { format: 'double', description: 'Third number; 0 without a value.' },
    gainA: { format: 'double', default: 1, description: 'Factor of a; a negative one subtracts.' },
    gainB: { format: 'double', default: 1, description: 'Factor of b; a negative one subtracts.' },
    gainC: { format: 'double', default: 1, description: 'Factor of c; a negative one subtracts.' },
  },
  outputs: {
    mixed: { format: 'double', description: 'Sum of the numbers times their gains.' },
  },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? value! : fallback;
      },
    };
    if (!inputs.a && !inputs.b && !inputs.c) return undefined;
    const mixed =
      read.number(inputs.a, 0) * read.number(inputs.gainA, 1) +
      read.number(inputs.b, 0) * read.number(inputs.gainB, 1) +
      read.number(inputs.c, 0) * read.number(inputs.gainC, 1);
    return Number.isFinite(mixed) ? { outputs: { mixed: { double: mixed } } } : undefined;
  },
});
