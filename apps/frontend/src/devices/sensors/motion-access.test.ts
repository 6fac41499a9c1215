import { describe, expect, it, vi } from 'vitest';
import { askForMotion, motionAccessOf } from './motion-access.ts';

const asking = (answer: () => Promise<PermissionState>) => ({
  isSecureContext: true,
  DeviceMotionEvent: { requestPermission: vi.fn(answer) },
  DeviceOrientationEvent: { requestPermission: vi.fn(answer) },
});
const silent = { isSecureContext: true, DeviceMotionEvent: {}, DeviceOrientationEvent: {} };

describe('access to motion', () => {
  it('is named before anybody is asked', () => {
    expect(motionAccessOf({ ...silent, isSecureContext: false })).toBe('insecure');
    expect(motionAccessOf({ isSecureContext: true })).toBe('unsupported');
    expect(motionAccessOf(silent)).toBe('granted');
    expect(motionAccessOf(asking(() => Promise.resolve('granted')))).toBe('ask');
  });

  it('is asked for both kinds of events at once, within the tap', async () => {
    const page = asking(() => Promise.resolve('granted'));
    const access = askForMotion(page);
    // Not after a first answer: the tap would be over.
    expect(page.DeviceMotionEvent.requestPermission).toHaveBeenCalledOnce();
    expect(page.DeviceOrientationEvent.requestPermission).toHaveBeenCalledOnce();
    expect(await access).toBe('granted');
  });

  it('is refused when the person says no', async () => {
    expect(await askForMotion(asking(() => Promise.resolve('denied')))).toBe('refused');
  });

  it('stays a question when there was no tap', async () => {
    const page = asking(() => Promise.reject(new DOMException('no gesture', 'NotAllowedError')));
    expect(await askForMotion(page)).toBe('ask');
  });

  it('needs no question where the browser has none', async () => {
    expect(await askForMotion(silent)).toBe('granted');
    expect(await askForMotion({ ...silent, isSecureContext: false })).toBe('insecure');
  });
});
