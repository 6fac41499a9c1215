/** Whether motion values arrive within `waitMs`. */
export function motionArrives(waitMs: number): Promise<boolean> {
  return new Promise((resolve) => {
    const finish = (arrives: boolean): void => {
      removeEventListener('devicemotion', handle);
      removeEventListener('deviceorientation', handle);
      clearTimeout(timer);
      resolve(arrives);
    };
    const handle = (event: DeviceMotionEvent | DeviceOrientationEvent): void => {
      const value =
        event instanceof DeviceOrientationEvent ? event.beta : event.rotationRate?.alpha;
      // Devices without sensors send one event without values.
      if (value !== null && value !== undefined) finish(true);
    };
    const timer = setTimeout(() => finish(false), waitMs);
    addEventListener('devicemotion', handle);
    addEventListener('deviceorientation', handle);
  });
}
