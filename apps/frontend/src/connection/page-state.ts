import type { UbiiClient } from '@ubii/client-web';
import { watchBattery, type BatteryState } from './battery.ts';

/** What a page says of itself and the device it is on. [EX-56] */
export interface PageState {
  /** It is in front; a page that is not says little, and may sleep. */
  readonly isVisible: boolean;
  /** `undefined` where the browser tells nothing. */
  readonly battery: BatteryState | undefined;
}

const PATTERN = /^\/[^/]+\/page_state$/;
/** More is no state of a page. */
const MAX_LENGTH = 1_000;

/** Where a page says it. */
export const pageStateTopic = (clientId: string): string => `/${clientId}/page_state`;

/** True when a page publishes its state there. */
export const isPageStateTopic = (topic: string): boolean => PATTERN.test(topic);

/** As it travels. */
export function writePageState({ isVisible, battery }: PageState): string {
  return JSON.stringify({
    visible: isVisible,
    ...(battery && {
      battery: Math.round(battery.level * 100) / 100,
      charging: battery.isCharging,
    }),
  });
}

/** What a record says; `undefined` when it is none. */
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

/** Says it when the page comes to the master, and whenever it changes. Viewers publish nothing. [AC-24] */
export function tellPageState(client: UbiiClient): void {
  let battery: BatteryState | undefined;
  let told = '';
  const tell = (isAgain = false): void => {
    const text = writePageState({ isVisible: document.visibilityState === 'visible', battery });
    if (client.state.status !== 'connected' || client.role === 'viewer') return;
    if (text === told && !isAgain) return;
    told = text;
    // A page that is hidden may have no other turn.
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
