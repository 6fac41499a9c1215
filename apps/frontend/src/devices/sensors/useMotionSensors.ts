import { useEventListener, useIntervalFn } from '@vueuse/core';
import { shallowRef } from 'vue';
import { askForMotion, type MotionAccess, motionAccessOf } from './motion-access.ts';

/** A device that moves at all tells of it within this time, milliseconds. */
const SILENCE_MS = 2000;

/** Safari has the heading of its own, degrees clockwise from north. */
type SafariOrientationEvent = DeviceOrientationEvent & { readonly webkitCompassHeading?: number };

/** Who is told what the sensors say, each at the sensor's own rate. */
export interface MotionHandlers {
  motion(event: DeviceMotionEvent): void;
  orientation(event: DeviceOrientationEvent): void;
  /** Degrees clockwise from north, 0 to 360. */
  compass(headingDegrees: number): void;
}

/** Motion sensors of this device, while the calling scope lives and as far as they are allowed. */
export function useMotionSensors(handlers: MotionHandlers) {
  const access = shallowRef<MotionAccess>(motionAccessOf(window));
  /** It is allowed, and yet nothing comes: most computers have no such sensors. */
  const isSilent = shallowRef(false);
  let lastMs = performance.now();
  const seen = (): void => {
    lastMs = performance.now();
    isSilent.value = false;
    // Some browsers can be asked, and need not be.
    access.value = 'granted';
  };

  // Listened to from the start: where it is not allowed, nothing comes.
  useEventListener(window, 'devicemotion', (event) => {
    // Browsers of computers send one event without any values.
    if (event.acceleration?.x == null && event.accelerationIncludingGravity?.x == null) return;
    seen();
    handlers.motion(event);
  });
  useEventListener(window, 'deviceorientation', (event: SafariOrientationEvent) => {
    if (event.beta === null) return;
    seen();
    handlers.orientation(event);
    const heading = event.webkitCompassHeading;
    if (heading !== undefined && heading >= 0) handlers.compass(heading);
  });
  // Chromium keeps what is relative to north in an event of its own.
  useEventListener(window, 'deviceorientationabsolute', (event: DeviceOrientationEvent) => {
    if (event.absolute && event.alpha !== null) handlers.compass((360 - event.alpha) % 360);
  });
  useIntervalFn(() => {
    isSilent.value = access.value === 'granted' && performance.now() - lastMs > SILENCE_MS;
  }, SILENCE_MS / 4);

  return {
    access,
    isSilent,
    /** To be called in the handler of a tap. */
    async ask(): Promise<void> {
      access.value = await askForMotion(window);
      lastMs = performance.now();
    },
  };
}
