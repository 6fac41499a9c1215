import { ClientState, type Client } from '@ubii/proto';
import { expect, it } from 'vitest';
import { hereFact } from './here-fact.ts';

const client = (state: ClientState): Client =>
  ({ state, description: 'Pixel 9', tags: [], isDedicatedProcessingNode: false }) as never;
const context = { isSelf: false, modules: 0, silence: undefined };

it.each([
  [ClientState.ACTIVE, context, 'Pixel 9'],
  [ClientState.ACTIVE, { ...context, modules: 3 }, 'runs 3 modules'],
  [ClientState.ACTIVE, { ...context, isSelf: true, modules: 3 }, 'this browser'],
  [ClientState.INACTIVE, { ...context, silence: '38 s' }, 'no response, 38 s'],
  [ClientState.UNAVAILABLE, { ...context, isSelf: true }, 'connection lost'],
])('a client in state %s with %o: %s', (state, given, text) => {
  expect(hereFact(client(state), given)).toEqual({
    text,
    isWarning: state === ClientState.INACTIVE,
  });
});
