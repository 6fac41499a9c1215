import type { Init, ProcessingModule } from '@ubii/proto';

/** A module that puts out the vector that came in, as soon as it came. */
export const ECHO_MODULE = {
  name: 'benchmark-echo',
  onProcessingStringified:
    '(deltaTime, inputs) => ({ outputs: { out: { vector3: inputs.in.vector3 } } })',
  inputs: [{ internalName: 'in', messageFormat: 'vector3' }],
  outputs: [{ internalName: 'out', messageFormat: 'vector3' }],
  processingMode: { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } },
} satisfies Init<ProcessingModule>;
