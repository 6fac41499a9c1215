import { ButtonEventType, TouchEventType as TouchType } from '@ubii/proto';
import type {
  Color,
  Image2D,
  Quaternion,
  TouchEventMessage,
  Vector2,
  Vector3,
  Vector4,
} from '@ubii/proto';
import { useEventListener, useIntervalFn } from '@vueuse/core';
import { onScopeDispose, shallowReactive, shallowRef, watch } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { playTone, unlockSound } from '../outputs/play-tone.ts';
import { vibrate } from '../outputs/vibrate.ts';
import {
  calibratedAngles,
  type EulerAngles,
  quaternionOf,
  turnSince,
} from '../sensors/orientation.ts';
import { useDeviceHealth } from '../sensors/useDeviceHealth.ts';
import { useLocation } from '../sensors/useLocation.ts';
import { useMicrophoneLevel } from '../sensors/useMicrophoneLevel.ts';
import { useMotionSensors } from '../sensors/useMotionSensors.ts';
import { SentRecords, type SentRate } from '../sensors/sent-records.ts';
import { useStayAwake } from '../sensors/useStayAwake.ts';
import { useDevice } from '../useDevice.ts';
import { SMART_DEVICE, SMART_DEVICE_COMPONENTS } from './components.ts';
import { NearSignal } from './near-signal.ts';
import { Reading } from './reading.ts';

/** Interval between updates of displayed sensor values, milliseconds. Sensors have their own rates. */
const READOUT_MS = 100;
/** Interval between updates of the displayed send rate, milliseconds. */
const SENT_MS = 1000;
/** Interval at which a resting finger is repeated, milliseconds: otherwise it would look like a lost one. */
const RESTING_TOUCH_MS = 500;
/** Shortest flash that replaces a vibration, milliseconds. */
const SHORTEST_FLASH_MS = 120;

/** This browser as a smart device: publishes its sensors, performs the outputs it receives. */
export function useSmartDevice() {
  const { isConnected } = useConnection();
  const readings = {
    linear: new Reading<Vector3>(({ x, y, z }) => Math.hypot(x, y, z)),
    acceleration: new Reading<Vector3>(({ x, y, z }) => Math.hypot(x, y, z)),
    rotationRate: new Reading<Vector3>(({ x, y, z }) => Math.hypot(x, y, z)),
    orientation: new Reading<Vector3>(({ y }) => y),
    compass: new Reading<number>((heading) => heading),
    microphone: new Reading<number>((level) => level),
    location: new Reading<Vector4>(({ w }) => w),
  };
  /** Received outputs, and their times, epoch milliseconds. */
  const outputs = shallowReactive({
    vibrationAtMs: undefined as number | undefined,
    /** True while the page flashes instead of a vibration or tone that the device could not perform. */
    isFlashing: false,
    toneAtMs: undefined as number | undefined,
    /** True when a tone arrived and the browser requires a tap before it plays sound. */
    isSilenced: false,
    isNear: false,
    color: undefined as Color | undefined,
    text: '',
    image: undefined as Image2D | undefined,
  });

  let flashTimer: ReturnType<typeof setTimeout> | undefined;
  function flash(durationMs: number): void {
    clearTimeout(flashTimer);
    outputs.isFlashing = durationMs > 0;
    const shownMs = Math.min(Math.max(durationMs, SHORTEST_FLASH_MS), 5000);
    flashTimer = setTimeout(() => (outputs.isFlashing = false), shownMs);
  }
  const shake = (durationMs: number): void => {
    if (!vibrate(durationMs)) flash(durationMs);
  };
  const sound = (tone: Vector3): void => {
    outputs.isSilenced = !playTone(tone);
  };

  const nearSignal = new NearSignal((isNear) => (outputs.isNear = isNear));
  onScopeDispose(() => nearSignal.end());

  const device = useDevice({
    name: SMART_DEVICE,
    tags: ['smart device', 'web interface'],
    components: SMART_DEVICE_COMPONENTS,
    receivers: {
      'web-component-vibration': (durationMs) => {
        outputs.vibrationAtMs = Date.now();
        shake(durationMs);
      },
      play_tone: (tone) => {
        outputs.toneAtMs = Date.now();
        sound(tone);
      },
      is_near: (isNear) => nearSignal.handle(isNear),
      set_color: (color) => (outputs.color = color.a > 0 ? color : undefined),
      show_text: (text) => (outputs.text = text),
      show_image: (image) => (outputs.image = image.data.length > 0 ? image : undefined),
    },
  });

  const sentRecords = new SentRecords(performance.now());
  const sent = shallowRef<SentRate>({ perSecond: 0, line: [] });
  const publish: typeof device.publish = (component, value, options) => {
    if (isConnected.value && device.isRegistered.value) sentRecords.note();
    device.publish(component, value, options);
  };
  useIntervalFn(() => (sent.value = sentRecords.sample(performance.now())), SENT_MS);

  let angles: EulerAngles | undefined;
  let zero: { readonly angles: EulerAngles; readonly turn: Quaternion } | undefined;
  const isCalibrated = shallowRef(false);

  const motion = useMotionSensors({
    motion({ acceleration, accelerationIncludingGravity, rotationRate }) {
      const nowMs = performance.now();
      if (isWhole(acceleration)) {
        const { x, y, z } = acceleration;
        publish('web-component-linear-acceleration', readings.linear.note({ x, y, z }, nowMs));
      }
      if (isWhole(accelerationIncludingGravity)) {
        const { x, y, z } = accelerationIncludingGravity;
        publish('acceleration', readings.acceleration.note({ x, y, z }, nowMs));
      }
      if (rotationRate?.alpha != null && rotationRate.beta != null && rotationRate.gamma != null) {
        const { alpha: x, beta: y, gamma: z } = rotationRate;
        publish('rotation_rate', readings.rotationRate.note({ x, y, z }, nowMs));
      }
    },
    orientation({ alpha, beta, gamma }) {
      angles = { alpha: alpha ?? 0, beta: beta ?? 0, gamma: gamma ?? 0 };
      const now = readings.orientation.note(
        calibratedAngles(angles, zero?.angles),
        performance.now(),
      );
      publish('web-component-orientation', now);
      const turn = quaternionOf(angles);
      publish('orientation_quaternion', zero ? turnSince(zero.turn, turn) : turn);
    },
    compass(heading) {
      publish('compass', readings.compass.note(heading, performance.now()));
    },
  });
  const microphone = useMicrophoneLevel((level) =>
    publish('microphone_level', readings.microphone.note(level, performance.now())),
  );
  const location = useLocation((place) =>
    publish('location', readings.location.note(place, performance.now())),
  );
  const health = useDeviceHealth({
    battery: (level) => publish('battery', level),
    visible: (isVisible) => publish('visible', isVisible, { immediate: true }),
  });
  // A restarted master has no state, and the values may not change for hours.
  watch([isConnected, device.isRegistered], (both) => both.every(Boolean) && health.tell());
  const awake = useStayAwake();
  useEventListener(window, 'pointerup', unlockSound);

  let restingAt: Vector2 | undefined;
  useIntervalFn(() => {
    if (restingAt) publish('touch_position', restingAt);
  }, RESTING_TOUCH_MS);

  useIntervalFn(() => {
    const nowMs = performance.now();
    for (const reading of Object.values(readings)) reading.show(nowMs);
  }, READOUT_MS);

  return {
    isRegistered: device.isRegistered,
    /** Rate of sent records. */
    sent,
    readings,
    outputs,
    motion,
    microphone,
    location,
    battery: health.battery,
    awake,
    isCalibrated,
    /** Sets the current orientation as zero; again: resets it. */
    calibrate(): void {
      zero = zero || !angles ? undefined : { angles, turn: quaternionOf(angles) };
      isCalibrated.value = zero !== undefined;
    },
    touch(events: TouchEventMessage[], first: Vector2 | undefined): void {
      // Starts and ends are not batched.
      const immediate = events.some(({ type }) => type !== TouchType.TOUCH_MOVE);
      publish('web-component-touch', { elements: events }, { immediate });
      const wasTouched = restingAt !== undefined;
      restingAt = first;
      // After the finger was lifted, no other touch is near.
      if (!first && wasTouched) publish('is_touched', false, { immediate: true });
      if (!first) return;
      publish('touch_position', first, { immediate });
      if (!wasTouched) publish('is_touched', true, { immediate: true });
    },
    press(key: string, isDown: boolean): void {
      const type = isDown ? ButtonEventType.DOWN : ButtonEventType.UP;
      publish('button', { type, key }, { immediate: true });
      if (isDown) vibrate(10);
    },
    sendText: (text: string) => publish('text', text, { immediate: true }),
    /** For testing the outputs. */
    testVibration: () => shake(200),
    testTone: () => sound({ x: 660, y: 180, z: 0.5 }),
  };
}

interface Axes {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** Browsers omit values that a sensor does not measure. */
function isWhole(
  value: DeviceMotionEventAcceleration | null,
): value is DeviceMotionEventAcceleration & Axes {
  return value !== null && value.x !== null && value.y !== null && value.z !== null;
}
