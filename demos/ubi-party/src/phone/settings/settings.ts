import { useLocalStorage } from '@vueuse/core';
import { inject, type InjectionKey, type Ref } from 'vue';

/** Control settings of this player, stored on the phone. */
export interface PhoneSettings {
  /** The hand that has the button. */
  readonly hand: 'left' | 'right';
  /** The method of turning the wheel. */
  readonly wheel: 'tilt' | 'thumb';
  /** A pointer sweeps by itself, the press takes its direction. */
  readonly hasOneButton: boolean;
  readonly hasLargeText: boolean;
}

export const FIRST_SETTINGS: PhoneSettings = {
  hand: 'right',
  wheel: 'tilt',
  hasOneButton: false,
  hasLargeText: false,
};

export const SETTINGS: InjectionKey<Ref<PhoneSettings>> = Symbol('settings');

export function useStoredSettings(): Ref<PhoneSettings> {
  return useLocalStorage<PhoneSettings>('ubii.party.phone', FIRST_SETTINGS, {
    mergeDefaults: true,
  });
}

export function useSettings(): Ref<PhoneSettings> {
  const settings = inject(SETTINGS);
  if (!settings) throw new Error('Screens of the phone live inside PartyPhone.');
  return settings;
}
