// @vitest-environment happy-dom
import { disableAutoUnmount, enableAutoUnmount, mount } from '@vue/test-utils';
import { afterEach, describe, expect, it } from 'vitest';
import { defineComponent, h, nextTick, ref, type Ref } from 'vue';
import type { CanvasStage } from './canvas-stage.ts';
import { useSpacePan } from './useSpacePan.ts';

// Another file of this worker may have enabled it.
disableAutoUnmount();
enableAutoUnmount(afterEach);

async function setUp() {
  let taps = 0;
  const container = document.createElement('div');
  const stage = { container, isPanning: false } as unknown as CanvasStage;
  const host: Ref<HTMLElement | null> = ref(null);
  mount(
    defineComponent(() => {
      useSpacePan(host, stage, () => (taps += 1));
      return () => h('div', { ref: host });
    }),
    { attachTo: document.body },
  );
  await nextTick();
  const key = (type: 'keydown' | 'keyup', more: KeyboardEventInit = {}): void => {
    const event = new KeyboardEvent(type, { key: ' ', bubbles: true, cancelable: true, ...more });
    host.value?.dispatchEvent(event);
  };
  const pointer = (): boolean => window.dispatchEvent(new Event('pointerdown'));
  return { stage, key, pointer, taps: () => taps };
}

describe('Space on the canvas', () => {
  it('pans while it is held, and is a tap when nothing else happened', async () => {
    const { stage, key, taps } = await setUp();
    key('keydown');
    expect(stage.isPanning).toBe(true);
    key('keyup');
    expect(stage.isPanning).toBe(false);
    expect(taps()).toBe(1);
  });

  it('is no tap when it repeats, with a pointer meanwhile, or with another key', async () => {
    const { key, pointer, taps } = await setUp();
    key('keydown');
    key('keydown', { repeat: true });
    key('keyup');
    key('keydown');
    pointer();
    key('keyup');
    key('keydown', { shiftKey: true });
    key('keyup');
    expect(taps()).toBe(0);
  });

  it('is no tap when it was pressed elsewhere', async () => {
    const { key, taps } = await setUp();
    key('keyup');
    expect(taps()).toBe(0);
  });
});
