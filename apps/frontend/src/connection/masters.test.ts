import { ClusterMasterState, type ClusterMaster } from '@ubii/proto';
import { expect, it } from 'vitest';
import { isGone, nameMasters } from './masters.ts';

const master = (id: string, name: string, address?: string): ClusterMaster =>
  ({ id, name, addresses: address === undefined ? [] : [address] }) as unknown as ClusterMaster;

const labels = (...masters: ClusterMaster[]): string[] =>
  nameMasters(masters).map(({ label }) => label);

it('names masters as they are called, and those of one name by their addresses', () => {
  expect(labels(master('1', 'hall', 'http://a:1'), master('2', 'foyer', 'http://b:1'))).toEqual([
    'hall',
    'foyer',
  ]);
  expect(
    labels(master('1', 'master-node', 'http://10.0.0.1:8080'), master('22222222-2', 'master-node')),
  ).toEqual(['master-node 10.0.0.1:8080', 'master-node 22222222']);
});

it('takes two runs of a master at one address for the same one', () => {
  expect(labels(master('1', 'hall', 'http://a:1'), master('2', 'hall', 'http://a:1'))).toEqual([
    'hall',
    'hall',
  ]);
});

it('takes lost and ended masters for gone', () => {
  const states = Object.values(ClusterMasterState);
  const gone = states.filter((state) => isGone({ state } as ClusterMaster));
  expect(gone).toEqual([ClusterMasterState.LOST, ClusterMasterState.ENDED]);
});
