import { describe, expect, it } from 'vitest';
import { EMPTY_RESULT } from '../../testing/fake-sandboxes.ts';
import { createModuleWorld } from '../../testing/module-world.ts';

const FREE = { mode: { free: {} } };

describe('a free module', () => {
  it('[PM-28] runs at most so many times a second', async () => {
    const { clock, sandboxes, begin } = createModuleWorld({ maxFreeHz: 100 });
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin(FREE);
    await clock.advance(1000);
    expect(sandboxes.last.calls).toHaveLength(101);
  });

  it('[PM-28] runs again when a longer run ended, after other work had a turn', async () => {
    const { clock, sandboxes, begin } = createModuleWorld({ maxFreeHz: 100 });
    await begin(FREE);
    await clock.advance(50);
    expect(sandboxes.last.calls).toHaveLength(1);
    sandboxes.last.finish();
    await clock.endTurn();
    expect(sandboxes.last.calls).toHaveLength(1);
    await clock.advance(0);
    expect(sandboxes.last.calls).toHaveLength(2);
  });

  it('[PM-29] stops when it is halted', async () => {
    const { clock, sandboxes, runtime, begin } = createModuleWorld();
    await begin(FREE);
    await clock.advance(10);
    const halted = runtime.halt('pm-1');
    sandboxes.last.finish();
    await halted;
    await clock.advance(1000);
    expect(sandboxes.last.calls).toHaveLength(1);
    expect(clock.timerCount).toBe(0);
  });
});
