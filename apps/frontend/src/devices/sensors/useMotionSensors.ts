import { useEventListener, useIntervalFn } from '@vueuse/core';
import { shallowRef } from 'vue';
import { askForMotion, type MotionAccess, motionAccessOf } from './motion-access.ts';

/** Time without events after which sensors are taken as missing, milliseconds. */
const SILENCE_MS = 2000;

/** Safari reports the compass heading in its own property, degrees clockwise from north. */
type SafariOrientationEvent = DeviceOrientationEvent & { readonly webkitCompassHeading?: number };

/** Receivers of sensor values, each at the sensor's own rate. */
export interface MotionHandlers {
  motion(event: DeviceMotionEvent): void;
  orientation(event: DeviceOrientationEvent): void;
  /** Degrees clockwise from north, 0 to 360. */
  compass(headingDegrees: number): void;
}

/** Motion sensors of this device, while the calling scope is active and as far as they are allowed. */
export function useMotionSensors(handlers: MotionHandlers) {
  const access = shallowRef<MotionAccess>(motionAccessOf(window));
  /** True when allowed without any event: most computers have no such sensors. */
  const isSilent = shallowRef(false);
  let lastMs = performance.now();
  const seen = (): void => {
    lastMs = performance.now();
    isSilent.value = false;
    // Some browsers offer the request, and deliver events without it.
    access.value = 'granted';
  };

  // Always subscribed: without permission, no events arrive.
  useEventListener(window, 'devicemotion', (event) => {
    // Desktop browsers send one event without values.
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
  // Chromium has a separate event for orientation relative to north.
  useEventListener(window, 'deviceorientationabsolute', (event: DeviceOrientationEvent) => {
    if (event.absolute && event.alpha !== null) handlers.compass((360 - event.alpha) % 360);
  });
  useIntervalFn(() => {
    isSilent.value = access.value === 'granted' && performance.now() - lastMs > SILENCE_MS;
  }, SILENCE_MS / 4);

  return {
    access,
    isSilent,
    /** Call it in the handler of a tap. */
    async ask(): Promise<void> {
      access.value = await askForMotion(window);
      lastMs = performance.now();
    },
  };
}
