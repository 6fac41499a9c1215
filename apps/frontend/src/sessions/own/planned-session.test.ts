import { fromJson } from '@ubii/proto';
import { expect, it } from 'vitest';
import { plannedSession } from './planned-session.ts';

const session = { name: 'Seeing', processingModules: [{ name: 'eyes' }, { name: 'hands' }] };

it('puts all modules on the node', () => {
  expect(plannedSession({ session, place: 'tab' }, undefined, 'n1')).toEqual({
    name: 'Seeing',
    processingModules: [
      { name: 'eyes', nodeId: 'n1' },
      { name: 'hands', nodeId: 'n1' },
    ],
  });
});

it('a module that runs keeps its id, also on another node [SE-15]; what is not wanted any more is left out', () => {
  const known = fromJson('ubii.sessions.Session', {
    id: 's1',
    processingModules: [
      { id: 'm1', name: 'eyes', nodeId: 'n1', extension: { replaceable: true } },
      { id: 'm2', name: 'ears', nodeId: 'n1' },
    ],
  });
  const { id, processingModules } = plannedSession({ session, place: 'tab' }, known, 'n2');
  expect(id).toBe('s1');
  expect(processingModules).toMatchObject([
    { id: 'm1', name: 'eyes', nodeId: 'n2', extension: { replaceable: false } },
    { name: 'hands', nodeId: 'n2' },
  ]);
  expect(processingModules).toHaveLength(2);
});
