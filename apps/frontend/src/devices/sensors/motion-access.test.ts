import { describe, expect, it, vi } from 'vitest';
import { askForMotion, motionAccessOf } from './motion-access.ts';

const navigator = { userAgent: 'Mozilla/5.0 (iPhone; …)', maxTouchPoints: 5 };
const asking = (answer: () => Promise<PermissionState>) => ({
  isSecureContext: true,
  navigator,
  DeviceMotionEvent: { requestPermission: vi.fn(answer) },
  DeviceOrientationEvent: { requestPermission: vi.fn(answer) },
});
const silent = {
  isSecureContext: true,
  navigator,
  DeviceMotionEvent: {},
  DeviceOrientationEvent: {},
};

describe('access to motion', () => {
  it('is known before the user is asked', () => {
    expect(motionAccessOf({ ...silent, isSecureContext: false })).toBe('insecure');
    expect(motionAccessOf({ isSecureContext: true, navigator })).toBe('unsupported');
    expect(motionAccessOf(silent)).toBe('granted');
    expect(motionAccessOf(asking(() => Promise.resolve('granted')))).toBe('ask');
  });

  it('is a question on iPads, which call themselves Macs, and not where Chromium answers it', () => {
    const page = asking(() => Promise.resolve('granted'));
    const mac = 'Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) AppleWebKit/605.1.15';
    const on = (userAgent: string, maxTouchPoints: number, userAgentData?: object) =>
      motionAccessOf({ ...page, navigator: { userAgent, maxTouchPoints, userAgentData } });
    expect(on(mac, 5)).toBe('ask');
    expect(on(`${mac} CriOS/140`, 5, {})).toBe('ask');
    expect(on('Mozilla/5.0 (Linux; Android 15) Chrome/140', 5, {})).toBe('granted');
    expect(on('Mozilla/5.0 (Windows NT 10.0) Chrome/140', 0, {})).toBe('granted');
    // An unknown browser: ask the user.
    expect(on('Something/1', 5)).toBe('ask');
  });

  it('is asked for both kinds of events at once, within the tap', async () => {
    const page = asking(() => Promise.resolve('granted'));
    const access = askForMotion(page);
    // Asked before the first answer: after it, the user interaction would be over.
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
