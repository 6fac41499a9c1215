import type { Replay } from '@ubii/proto';
import { expect, it } from 'vitest';
import { ReplayControl, type ReplayChange } from './replay-control.ts';

it('sends one change at a time, and what was wished meanwhile as the next one', async () => {
  const sent: ReplayChange[] = [];
  let reply: (replay: Replay | undefined) => void = () => undefined;
  const control = new ReplayControl((change) => {
    sent.push(change);
    return new Promise((resolve) => (reply = resolve));
  });
  control.change({ seek: { positionMs: 1 } });
  control.change({ seek: { positionMs: 2 } });
  control.change({ rate: 2 });
  control.change({ seek: { positionMs: 3 } });
  expect(sent).toEqual([{ seek: { positionMs: 1 } }]);
  expect(control.isBusy).toBe(true);
  reply(undefined);
  await Promise.resolve();
  expect(sent[1]).toEqual({ seek: { positionMs: 3 }, rate: 2 });
  reply(undefined);
  await Promise.resolve();
  await Promise.resolve();
  expect(control.isBusy).toBe(false);
  expect(sent).toHaveLength(2);
});
