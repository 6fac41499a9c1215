import { expect, it, vi } from 'vitest';
import { ownTopicRemedy } from './own-topic-remedy.ts';

it('says what to do for a topic of this browser that nothing is sent to', () => {
  expect(ownTopicRemedy('/me/web-interface-smart-device/touch_position', 'me')).toEqual({
    message:
      'Nothing is sent to touch_position. Open Smart device and touch the pad: it publishes while its page is open.',
    text: 'Open Smart device',
    to: '/devices/smart-device',
  });
  expect(ownTopicRemedy('me/orientation', 'me')?.message).toContain('allow its sensors');
});

it('opens the pad of the page for a touch, where there is one', () => {
  const openPad = vi.fn();
  const remedy = ownTopicRemedy('/me/web-interface-smart-device/touch_position', 'me', openPad);
  expect(remedy).toMatchObject({
    message: 'Nothing is sent to touch_position yet. Open the touch pad below, and touch it.',
    text: 'Open the touch pad',
  });
  expect(remedy).not.toHaveProperty('to');
  remedy?.run?.();
  expect(openPad).toHaveBeenCalledOnce();
  expect(ownTopicRemedy('me/orientation', 'me', openPad)?.to).toBe('/devices/smart-device');
});

it('says nothing of topics of others, and of those that the device only reads', () => {
  expect(ownTopicRemedy('/ines/web-interface-smart-device/touch_position', 'me')).toBeUndefined();
  expect(ownTopicRemedy('/me/vibration_pattern', 'me')).toBeUndefined();
  expect(ownTopicRemedy('/me/other', 'me')).toBeUndefined();
});
