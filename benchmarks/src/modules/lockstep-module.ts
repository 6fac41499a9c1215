import type { Init, ProcessingModule } from '@ubii/proto';

/** A module that says which pass it is in, and what it found on its input. */
export const LOCKSTEP_MODULE = {
  name: 'benchmark-lockstep',
  onProcessingStringified: `(deltaTime, inputs, state) => {
    state.pass = (state.pass || 0) + 1;
    return { outputs: { out: { vector3: { x: state.pass, y: inputs.in.double, z: deltaTime } } } };
  }`,
  inputs: [{ internalName: 'in', messageFormat: 'double' }],
  outputs: [{ internalName: 'out', messageFormat: 'vector3' }],
  processingMode: { lockstep: {} },
} satisfies Init<ProcessingModule>;

/** Where a node of the benchmark answers at once: what comes on `ping` goes back on `pong`. */
export function echoTopics(node: string) {
  return { ping: `/benchmark/nodes/${node}/ping`, pong: `/benchmark/nodes/${node}/pong` };
}

/** Where it is asked for its passes since the question before, and where it says so. */
export function passTopics(node: string) {
  return { ask: `/benchmark/nodes/${node}/ask`, passes: `/benchmark/nodes/${node}/passes` };
}
