import type { UbiiClient } from '@ubii/client-web';
import { watchBattery, type BatteryState } from './battery.ts';

/** State that a page publishes about itself and its device. [EX-56] */
export interface PageState {
  /** True in the foreground; hidden pages publish rarely and may be suspended. */
  readonly isVisible: boolean;
  /** `undefined` where the browser does not provide it. */
  readonly battery: BatteryState | undefined;
}

const PATTERN = /^\/[^/]+\/page_state$/;
/** Longest valid page state, characters. */
const MAX_LENGTH = 1_000;

/** Topic of a page's state. */
export const pageStateTopic = (clientId: string): string => `/${clientId}/page_state`;

/** True for topics of page states. */
export const isPageStateTopic = (topic: string): boolean => PATTERN.test(topic);

/** Serialises a page state. */
export function writePageState({ isVisible, battery }: PageState): string {
  return JSON.stringify({
    visible: isVisible,
    ...(battery && {
      battery: Math.round(battery.level * 100) / 100,
      charging: battery.isCharging,
    }),
  });
}

/** Parses a record; `undefined` when it is not a page state. */
export function readPageState(text: string): PageState | undefined {
  if (text.length > MAX_LENGTH) return undefined;
  let said: unknown;
  try {
    said = JSON.parse(text);
  } catch {
    return undefined;
  }
  if (typeof said !== 'object' || said === null) return undefined;
  const { visible, battery, charging } = said as Record<string, unknown>;
  if (typeof visible !== 'boolean') return undefined;
  const hasBattery = typeof battery === 'number' && battery >= 0 && battery <= 1;
  return {
    isVisible: visible,
    battery: hasBattery ? { level: battery, isCharging: charging === true } : undefined,
  };
}

/** Publishes the state after connecting and whenever it changes. Viewers publish nothing. [AC-24] */
export function tellPageState(client: UbiiClient): void {
  let battery: BatteryState | undefined;
  let told = '';
  const tell = (isAgain = false): void => {
    const text = writePageState({ isVisible: document.visibilityState === 'visible', battery });
    if (client.state.status !== 'connected' || client.role === 'viewer') return;
    if (text === told && !isAgain) return;
    told = text;
    // Sent at once, because a hidden page may be suspended.
    client.publish(pageStateTopic(client.id), 'string', text, { immediate: true });
  };
  client.onState(({ status }) => {
    if (status === 'connected') tell(true);
  });
  document.addEventListener('visibilitychange', () => tell());
  watchBattery((state) => {
    battery = state;
    tell();
  });
}
