import { useEventListener, useRafFn } from '@vueuse/core';
import {
  computed,
  inject,
  onScopeDispose,
  shallowRef,
  toValue,
  watch,
  type ComputedRef,
  type InjectionKey,
  type MaybeRefOrGetter,
  type ShallowRef,
} from 'vue';

import type { PhoneLink } from '../../net/phone/phone-link.ts';
import type { Controller } from '../../sim/index.ts';
import { PRESS_MS, vibrate } from '../frame/haptics.ts';
import type { PhoneSettings } from '../settings/settings.ts';
import { ControlOutput, PRESSERS, type Presser } from './control-output.ts';
import {
  readGamepads,
  isPressKey,
  isSteeringKey,
  steeringOfKeys,
  ONE_BUTTON_AT_REST,
  pressed,
  sweepOf,
  swept,
} from './steering-inputs.ts';
import { STRAIGHT, type Steering } from './stick.ts';
import type { Tilt } from './useTilt.ts';

/** Input handlers and displayed state of the pads. */
export interface Controls {
  /** The steering that is sent. */
  readonly steering: Readonly<ShallowRef<Steering>>;
  readonly isDown: Readonly<ShallowRef<boolean>>;
  /** Direction of the pointer of one-button steering; undefined when it is off. */
  readonly pointer: Readonly<ShallowRef<Steering | undefined>>;
  readonly hasOneButton: ComputedRef<boolean>;
  /** Grows when everything was let go: pads forget the fingers on them. */
  readonly releases: Readonly<ShallowRef<number>>;
  /** @param steering undefined: the thumb is off */
  steerByThumb(steering: Steering | undefined): void;
  press(by: Presser, isDown: boolean): void;
}

export const CONTROLS: InjectionKey<Controls> = Symbol('controls');

interface ControlOptions {
  readonly link: Pick<PhoneLink, 'steer' | 'press'>;
  readonly controller: MaybeRefOrGetter<Controller>;
  readonly settings: MaybeRefOrGetter<PhoneSettings>;
  readonly tilt: Tilt;
  /** The menu is open: everything is let go. */
  readonly isPaused: MaybeRefOrGetter<boolean>;
  /** Presses before the start answer, and are not sent. */
  readonly isStarted: MaybeRefOrGetter<boolean>;
}

/** Plays one round for as long as the calling scope lives. */
export function createControls(options: ControlOptions): Controls {
  const { link, tilt } = options;
  const output = new ControlOutput({
    steer: (x, y) => link.steer(x, y),
    press: (isPressed) => {
      if (toValue(options.isStarted)) link.press(isPressed);
    },
  });
  const steering = shallowRef<Steering>(STRAIGHT);
  const isDown = shallowRef(false);
  const pointer = shallowRef<Steering>();
  const releases = shallowRef(0);
  const kind = computed(() => toValue(options.controller).steering);
  const hasOneButton = computed(
    () => toValue(options.settings).hasOneButton && kind.value !== 'none',
  );
  let oneButton = ONE_BUTTON_AT_REST;
  const keys = new Set<string>();
  let wasGamepadPressed = false;

  function press(by: Presser, isPressed: boolean): void {
    if (toValue(options.isPaused) || !output.press(by, isPressed)) return;
    isDown.value = isPressed;
    if (isPressed) vibrate(PRESS_MS);
    if (!hasOneButton.value) return;
    oneButton = pressed(oneButton, isPressed, kind.value);
    output.steer('one-button', oneButton.taken);
  }

  function releaseButton(): void {
    for (const presser of PRESSERS) output.press(presser, false);
    isDown.value = false;
  }

  function release(): void {
    keys.clear();
    output.release();
    isDown.value = false;
    steering.value = STRAIGHT;
    oneButton = { ...oneButton, isHeld: false, taken: STRAIGHT };
    releases.value += 1;
  }

  function readKey(event: KeyboardEvent, isKeyDown: boolean): void {
    if (toValue(options.isPaused) || event.metaKey || event.ctrlKey || event.altKey) return;
    if (isPressKey(event.code)) {
      // A focused button of the page is for users of a screen reader or of Tab.
      if ((event.target as Element | null)?.closest?.('button:not([data-pad])')) return;
      event.preventDefault();
      if (!event.repeat) press('keys', isKeyDown);
    } else if (isSteeringKey(event.code)) {
      event.preventDefault();
      if (isKeyDown) keys.add(event.code);
      else keys.delete(event.code);
      output.steer('keys', keys.size > 0 ? steeringOfKeys(keys) : undefined);
    }
  }

  function frame(passedMs: number): void {
    if (toValue(options.isPaused)) return;
    const gamepad = readGamepads(navigator.getGamepads?.() ?? []);
    const isMoved = gamepad.steering.x !== 0 || gamepad.steering.y !== 0;
    output.steer('gamepad', isMoved ? gamepad.steering : undefined);
    if (gamepad.isPressed !== wasGamepadPressed) press('gamepad', gamepad.isPressed);
    wasGamepadPressed = gamepad.isPressed;
    oneButton = swept(oneButton, passedMs);
    pointer.value = hasOneButton.value ? sweepOf(oneButton, kind.value) : undefined;
    if (!hasOneButton.value) output.steer('one-button', undefined);
    output.steer('tilt', steeringByTilt());
    steering.value = output.frame();
  }

  function steeringByTilt(): Steering | undefined {
    const isWanted = kind.value === 'wheel' && toValue(options.settings).wheel === 'tilt';
    const x = isWanted && !hasOneButton.value ? tilt.steering() : undefined;
    return x === undefined ? undefined : { x, y: 0 };
  }

  useRafFn(({ delta }) => frame(delta));
  useEventListener(window, 'keydown', (event) => readKey(event, true));
  useEventListener(window, 'keyup', (event) => readKey(event, false));
  useEventListener(window, 'blur', release);
  useEventListener(document, 'visibilitychange', () => {
    if (document.visibilityState === 'hidden') release();
  });
  watch(() => toValue(options.isPaused), release, { flush: 'sync' });
  // A button that is held from before the start is pressed again by choice: in a duel it would be too early.
  watch(() => toValue(options.isStarted), releaseButton, { flush: 'sync' });
  onScopeDispose(release);

  return {
    steering,
    isDown,
    pointer,
    hasOneButton,
    releases,
    steerByThumb: (to) => {
      if (!toValue(options.isPaused)) output.steer('thumb', to);
    },
    press,
  };
}

export function useControls(): Controls {
  const controls = inject(CONTROLS);
  if (!controls) throw new Error('Pads live inside PlayScreen.');
  return controls;
}

/** Puts the focus on the button of the round, so that Space plays and does not open the menu again. */
export function focusPad(): void {
  document.querySelector<HTMLElement>('[data-pad]')?.focus({ preventScroll: true });
}
