import type { Session } from '@ubii/proto';
import { expect, it } from 'vitest';
import { formatClock } from '../../ui/readouts/format-clock.ts';
import { sessionMaster } from './master-words.ts';

const MOVED_MS = 1_800_000_000_000;
const session = (extension: object): Session => ({ extension }) as unknown as Session;
const masters = {
  labelOf: (id: string | undefined) => (id === undefined || id === '' ? '' : `master ${id}`),
  isGone: (id: string) => id === 'lost',
};

it('says where a session runs and from where it came, among several masters only [CU-71]', () => {
  const said = (extension: object) => sessionMaster(session(extension), masters)?.text;
  expect(sessionMaster(session({}), masters)).toBeUndefined();
  expect(said({ masterId: 'b' })).toBe('On the master master b.');
  expect(said({ masterId: 'b', movedFrom: 'hall', movedMs: MOVED_MS })).toBe(
    `On the master master b. Taken over from the lost master hall at ${formatClock(MOVED_MS)}.`,
  );
  expect(said({ masterId: 'b', movedMs: MOVED_MS })).toContain('Taken over from a lost master at');
});

it('says that a session waits for another master when its master is lost [CU-71]', () => {
  expect(sessionMaster(session({ masterId: 'lost' }), masters)).toMatchObject({
    label: 'master lost',
    isLost: true,
  });
});
