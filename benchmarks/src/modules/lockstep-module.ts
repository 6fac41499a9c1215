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

/** Topics for round trips to a node of the benchmark: it publishes records from `ping` on `pong` at once. */
export function echoTopics(node: string) {
  return { ping: `/benchmark/nodes/${node}/ping`, pong: `/benchmark/nodes/${node}/pong` };
}

/** Topics for pass durations of a node: the request, and the durations since the request before. */
export function passTopics(node: string) {
  return { ask: `/benchmark/nodes/${node}/ask`, passes: `/benchmark/nodes/${node}/passes` };
}
