import { AccessRole, ReplayState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { joinAs } from './access-world.ts';
import {
  at,
  change,
  ledger,
  list,
  makerOfRecording,
  masterWith,
  play,
  RECORDING,
  stop,
} from './replay-world.ts';

const { REPLAY_STATE_PAUSED } = ReplayState;

describe('the end of a replay', () => {
  it('[RP-6] is for those who started it, and for admins', async () => {
    const master = await masterWith();
    const ada = await makerOfRecording(master);
    const bob = await joinAs(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const viewer = await joinAs(master, AccessRole.ACCESS_ROLE_VIEWER);
    await expect(play(viewer)).rejects.toThrow('permission_denied');
    const { id } = await play(ada);
    expect(await stop(bob, id)).toBe('permission_denied');
    await expect(change(bob, { id, rate: 2 })).rejects.toThrow('permission_denied');
    expect(await stop(ada, id)).toBe(undefined);
    const second = await play(ada);
    expect(await stop(master, second.id)).toBe(undefined);
  });

  it('[RP-6] comes with the deletion of its recording', async () => {
    const master = await masterWith();
    const before = await ledger(master);
    await play(master);
    await master.pass(200);
    const request = {
      topic: '/services/ubii/recording_delete',
      recordingRequest: { id: RECORDING },
    };
    expect((await master.call(request)).error).toBe(undefined);
    expect(await list(master)).toEqual([]);
    await master.pass(2_000);
    expect(await ledger(master)).toEqual(before);
  });

  it('[RP-6] comes when an admin disconnects its client', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    const { clientIds } = await play(master, { isPaused: true });
    await master.call({
      topic: '/services/ubii/client_disconnect',
      clientDisconnectRequest: { targetId: clientIds[0]! },
    });
    expect(await list(master)).toEqual([]);
    bob.publish('/a', 'double', -1);
    expect(bob.takeErrors()).toEqual([]);
  });

  it('[RP-6] comes with the end of the master', async () => {
    const master = await masterWith();
    await play(master);
    await master.master.close();
    expect(master.clock.timerCount).toBe(0);
  });

  it('[RP-2] waits when the file cannot be read, and goes on when it can', async () => {
    const master = await masterWith([at('/a', 0), at('/a', 5_000)]);
    const { id } = await play(master, { isPaused: true });
    const file = master.recordings.files.get(RECORDING)!;
    const read = file.read.bind(file);
    file.read = () => Promise.reject(new Error('EIO: i/o error, read.'));
    const failed = await change(master, { id, seek: { positionMs: 5_000 } });
    expect(failed.state).toBe(ReplayState.REPLAY_STATE_FAILED);
    expect(failed.problem).toContain('EIO');
    file.read = read;
    const { state, problem } = await change(master, { id, seek: { positionMs: 5_000 } });
    expect([state, problem]).toEqual([REPLAY_STATE_PAUSED, '']);
  });
});
