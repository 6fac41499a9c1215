import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { effectScope, nextTick, ref, shallowRef, type EffectScope } from 'vue';
import { useLiveSending } from './useLiveSending.ts';

let scope: EffectScope;
let frames: (() => void)[];
const send = vi.fn();
const json = shallowRef<Record<string, unknown>>({});
const isOn = ref(true);
const format = ref('double');

beforeEach(() => {
  frames = [];
  send.mockClear();
  vi.stubGlobal('requestAnimationFrame', (run: () => void) => frames.push(run));
  json.value = { topic: '/lab', double: 1 };
  format.value = 'double';
  isOn.value = false;
  scope = effectScope();
  scope.run(() =>
    useLiveSending(() => ({ format: format.value, value: json.value[format.value] }), isOn, send),
  );
});
afterEach(() => {
  scope.stop();
  vi.unstubAllGlobals();
});

async function settle(): Promise<void> {
  await nextTick();
  for (const run of frames.splice(0)) run();
}

it('sends nothing while off, nor when it is switched on', async () => {
  json.value = { topic: '/lab', double: 2 };
  await settle();
  isOn.value = true;
  await settle();
  expect(send).not.toHaveBeenCalled();
});

it('sends a changed value once per frame, but not a changed topic or data format', async () => {
  isOn.value = true;
  await settle();
  for (const topic of ['/', '/l', '/la']) {
    json.value = { topic, double: 1 };
    await settle();
  }
  format.value = 'bool';
  json.value = { topic: '/la', bool: false };
  await settle();
  expect(send).not.toHaveBeenCalled();
  json.value = { topic: '/la', bool: true };
  await nextTick();
  json.value = { topic: '/la', bool: false };
  await nextTick();
  await settle();
  expect(send).toHaveBeenCalledTimes(1);
});
