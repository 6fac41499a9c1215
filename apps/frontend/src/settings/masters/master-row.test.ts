import { ClusterMasterState, type ClusterMaster } from '@ubii/proto';
import { expect, it } from 'vitest';
import { MASTER_FIGURES, masterRow } from './master-row.ts';

const NOW = 1_800_000_000_000;

function row(changes: Partial<ClusterMaster>, reachable = true) {
  const master = {
    id: 'm',
    name: 'hall',
    addresses: ['http://hall:8080'],
    version: '1.2.3',
    sinceMs: NOW - 90_000,
    clients: 3,
    sessions: 2,
    recordsToPerSecond: 120,
    bytesToPerSecond: 4_200,
    recordsFromPerSecond: 0,
    bytesFromPerSecond: 80,
    roundTripMs: 1.4,
    dropped: 0,
    gaps: 0,
    complete: true,
    ...changes,
  } as ClusterMaster;
  return masterRow({ master, label: 'hall' }, { reachable }, NOW);
}
const { SELF, PRESENT, LOST, ENDED } = ClusterMasterState;

it('says of each master whether it is there, and since when [CU-72]', () => {
  const words = (changes: Partial<ClusterMaster>, reachable?: boolean): string =>
    row(changes, reachable).word;
  expect(words({ state: SELF })).toBe('own master');
  expect(words({ state: SELF }, false)).toBe('own master, alone');
  expect(words({ state: PRESENT })).toBe('connected');
  expect(words({ state: PRESENT, complete: false })).toBe('synchronizing');
  expect(words({ state: LOST })).toBe('lost');
  expect(words({ state: LOST }, false)).toBe('out of reach');
  expect(words({ state: ENDED })).toBe('ended');
  expect(row({ state: PRESENT })).toMatchObject({ since: '1 min', address: 'http://hall:8080' });
});

it('has what crosses of other masters, and of the own one its clients and sessions [CU-73]', () => {
  const digits = (state: ClusterMaster['state']): string[] =>
    row({ state }).figures.map(({ readout }) => readout.digits);
  expect(digits(PRESENT)).toEqual(['3', '2', '120', '0', '1.4', '0', '0']);
  expect(digits(SELF)).toEqual(['3', '2', '–', '–', '–', '–', '–']);
  expect(digits(LOST)).toEqual(MASTER_FIGURES.map(() => '–'));
});

it('warns of records that were dropped', () => {
  const dropped = row({ state: PRESENT, dropped: 4 }).figures.find(
    ({ name }) => name === 'Dropped',
  );
  expect(dropped).toMatchObject({ readout: { digits: '4' }, isWarning: true });
});
