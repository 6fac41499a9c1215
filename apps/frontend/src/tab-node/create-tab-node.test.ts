// @vitest-environment happy-dom
import type { ProcessingNode } from '@ubii/client-web/processing';
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, type EffectScope } from 'vue';
import { createTabNode, tabNodeLoad } from './create-tab-node.ts';

let scope: EffectScope;
beforeEach(() => {
  sessionStorage.clear();
  scope = effectScope();
});
afterEach(() => scope.stop());

function setup() {
  const done: string[] = [];
  let isStarted = false;
  const node = {
    get isStarted() {
      return isStarted;
    },
    instances: [],
    onChange: () => () => undefined,
    setAcceptsWork: async (accepts: boolean) => void done.push(`accepts ${accepts}`),
    start: async () => {
      isStarted = true;
      done.push('start');
    },
    stop: async () => {
      isStarted = false;
      done.push('stop');
    },
  } as unknown as ProcessingNode;
  const open = vi.fn(async () => node);
  const tab = scope.run(() => createTabNode({} as never, open))!;
  return { tab, done, open };
}

describe('this tab as a node', () => {
  it('loads nothing before it is needed', async () => {
    const { open, tab } = setup();
    await flushPromises();
    expect(open).not.toHaveBeenCalled();
    expect(tab.state.value).toEqual({ status: 'off' });
  });

  it('takes part while it is chosen, and lets the master choose it [PM-60]', async () => {
    const { tab, done } = setup();
    tab.isChosen.value = true;
    await tab.whenOn();
    expect(done).toEqual(['accepts true', 'start']);
    tab.isChosen.value = false;
    await flushPromises();
    expect(done.at(-1)).toBe('stop');
    expect(tab.state.value).toEqual({ status: 'off' });
  });

  it('takes part for a page that needs it, but only sessions that name it may use it', async () => {
    const { tab, done } = setup();
    const release = tab.need();
    await tab.whenOn();
    expect(done).toEqual(['accepts false', 'start']);
    release();
    await flushPromises();
    expect(done.at(-1)).toBe('stop');
  });

  it('is on again after a reload', async () => {
    const first = setup();
    first.tab.isChosen.value = true;
    await flushPromises();
    const second = setup();
    await second.tab.whenOn();
    expect(second.done).toContain('start');
  });

  it('says why it cannot', async () => {
    const { tab, open } = setup();
    open.mockRejectedValueOnce(new Error('This browser has no workers.'));
    tab.isChosen.value = true;
    await expect(tab.whenOn()).rejects.toThrow('This browser has no workers.');
    expect(tab.state.value).toEqual({ status: 'failed', reason: 'This browser has no workers.' });
  });

  it('counts the time modules take', () => {
    const statistics = { runsPerSecond: 50, runP50Ms: 2 };
    const instances = [{ statistics }, { statistics: undefined }] as never;
    expect(tabNodeLoad(instances)).toEqual({ instances: 2, runsPerSecond: 50, load: 0.1 });
  });
});
