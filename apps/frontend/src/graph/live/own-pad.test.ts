import { expect, it } from 'vitest';
import { effectScope, nextTick, ref, shallowRef } from 'vue';
import { createOwnPad } from './own-pad.ts';

const TOUCH = '/me/web-interface-smart-device/touch_position';

function setUp({ isPhone = true, isTouch = true } = {}) {
  const isRunning = ref(false);
  const topics = shallowRef<readonly string[]>([TOUCH]);
  const published = ref(false);
  const pad = effectScope().run(() =>
    createOwnPad({
      isTouch: ref(isTouch),
      isPhone: ref(isPhone),
      isRunning: () => isRunning.value,
      ownTouches: () => topics.value,
      isPublished: () => published.value,
    }),
  )!;
  return { pad, isRunning, topics, published };
}

it('opens by itself on a phone while the session runs', () => {
  const { pad, isRunning } = setUp();
  expect(pad.isOpen.value).toBe(false);
  isRunning.value = true;
  expect(pad.isOpen.value).toBe(true);
  isRunning.value = false;
  expect(pad.isOpen.value).toBe(false);
});

it('stays closed once the user has closed it, and opens again when asked', () => {
  const { pad, isRunning } = setUp();
  isRunning.value = true;
  pad.isOpen.value = false;
  expect(pad.isOpen.value).toBe(false);
  pad.isOpen.value = true;
  expect(pad.isOpen.value).toBe(true);
});

it('waits for the user where it has no room, and is not offered without a touch to read', () => {
  const tablet = setUp({ isPhone: false });
  tablet.isRunning.value = true;
  expect([tablet.pad.isOffered.value, tablet.pad.isOpen.value]).toEqual([true, false]);
  const phone = setUp();
  phone.isRunning.value = true;
  phone.topics.value = [];
  expect([phone.pad.isOffered.value, phone.pad.isOpen.value]).toEqual([false, false]);
  expect(setUp({ isTouch: false }).pad.isOffered.value).toBe(false);
});

it('takes a missing touch for a problem only while it was never touched and is closed', async () => {
  const { pad, isRunning, published } = setUp();
  expect(pad.isResting(TOUCH)).toBe(false);
  isRunning.value = true;
  expect(pad.isResting(TOUCH)).toBe(true);
  pad.isOpen.value = false;
  expect(pad.isResting(TOUCH)).toBe(false);
  published.value = true;
  await nextTick();
  published.value = false;
  expect(pad.isResting(TOUCH)).toBe(true);
  expect(pad.isResting('/ines/web-interface-smart-device/touch_position')).toBe(false);
});

it('leaves a missing touch a problem where no pad is offered', () => {
  const { pad, published } = setUp({ isTouch: false });
  published.value = true;
  expect(pad.isResting(TOUCH)).toBe(false);
});
