import type { Platform } from '../../../connection/platform.ts';
import type { MotionAccess } from '../../../devices/sensors/motion-access.ts';
import { CERTIFICATE_PATH } from '../../../locations/certificate-location.ts';
import type { Check } from './check.ts';
import type { ChannelProbe } from './probe-channel.ts';

/** Offset from which a wrong clock is reported, milliseconds. */
const CLOCK_OFF_MS = 2000;

/** Formats milliseconds: `0.8 ms`, `12 ms`. */
export function formatMs(ms: number): string {
  return `${ms < 10 ? Math.max(0.1, Math.round(ms * 10) / 10) : Math.round(ms)} ms`;
}

/** @param tripMs `undefined` without a reply */
export function masterCheck(tripMs: number | undefined, page: URL): Check {
  const { hostname, port, protocol } = page;
  const id = 'master';
  if (tripMs !== undefined) {
    return {
      id,
      state: 'good',
      title: 'Host reached',
      text: `${hostname}, port ${port || (protocol === 'https:' ? '443' : '80')}`,
      value: formatMs(tripMs),
    };
  }
  const name = hostname.endsWith('.local')
    ? ' Many Android phones, and all phones behind a VPN, cannot find names that end in .local: open the numeric address on the host’s screen.'
    : '';
  return {
    id,
    state: 'failed',
    title: 'Host not reached',
    text: `${hostname} does not answer.${name} Use the same Wi-Fi as the host, and turn mobile data and VPN off. Guest networks often separate devices (client isolation): use another network or a hotspot. On the host, a firewall may block port ${port || '443'}, or Ubi-Interact has stopped.`,
  };
}

export function secureCheck(isSecure: boolean, page: URL): Check {
  const id = 'secure';
  if (page.protocol === 'https:') {
    return {
      id,
      state: 'good',
      title: 'Secure page',
      text: 'Certificate accepted on this device',
      value: 'HTTPS',
    };
  }
  if (isSecure) {
    return {
      id,
      state: 'good',
      title: 'Secure page',
      text: 'The page comes from this computer',
      value: 'local',
    };
  }
  return {
    id,
    state: 'warning',
    title: 'Plain HTTP',
    text: 'Browsers allow motion sensors, camera and microphone on secure pages only. The secure page first shows a certificate warning: continue past it, or install the certificate.',
    value: 'HTTP',
    remedy: { text: 'Open the secure page', href: securePage(page) },
  };
}

/** URL of the same page over HTTPS, which the master serves on the same port. */
export function securePage(page: URL): string {
  const secure = new URL(page);
  secure.protocol = 'https:';
  return secure.href;
}

/** @param probe `undefined` when the master is not reachable */
export function channelCheck(
  probe: ChannelProbe | undefined,
  platform: Platform,
  page: URL,
): Check {
  const id = 'channel';
  if (probe === undefined) {
    return {
      id,
      state: 'failed',
      title: 'Live connection',
      text: 'Needs a connection to the host.',
    };
  }
  if (probe.isOpen) {
    return {
      id,
      state: 'good',
      title: 'Live connection',
      text: 'Works in both directions',
      value: formatMs(probe.roundTripMs),
    };
  }
  const title = 'Live connection blocked';
  if (platform === 'ios' && page.protocol === 'https:') {
    return {
      id,
      state: 'failed',
      title,
      text: 'The page loaded, but its WebSocket is blocked. iOS often blocks it until the certificate is installed. Install the certificate and turn on full trust for it.',
      remedy: { text: 'Install the certificate', href: CERTIFICATE_PATH },
    };
  }
  return {
    id,
    state: 'failed',
    title,
    text:
      probe.reason === 'silent'
        ? 'The WebSocket opened too slowly or carries no data. A proxy or VPN delays it: turn it off for this network, or use another network.'
        : 'The page loaded, but its WebSocket is blocked by a proxy, VPN, content blocker or security app. Turn it off for this address, or use another browser or network.',
    ...(page.protocol === 'https:'
      ? { remedy: { text: 'Install the certificate', href: CERTIFICATE_PATH } }
      : {}),
  };
}

export function clockCheck(probe: ChannelProbe | undefined): Check {
  const id = 'clock';
  const title = 'Clock';
  if (probe === undefined || !probe.isOpen) {
    return { id, state: 'none', title, text: 'Compared over the live connection' };
  }
  const { offsetMs, errorMs } = probe;
  const value = `±${formatMs(errorMs)}`;
  if (Math.abs(offsetMs) <= CLOCK_OFF_MS) {
    return { id, state: 'good', title, text: 'Synchronized with the host', value };
  }
  const seconds = Math.round(Math.abs(offsetMs) / 1000);
  const off = seconds < 120 ? `${seconds} s` : `${Math.round(seconds / 60)} min`;
  return {
    id,
    state: 'warning',
    title,
    text: `${off} ${offsetMs > 0 ? 'behind' : 'ahead of'} the host. This device shows wrong times until its clock is set. Nothing else is affected.`,
    value,
  };
}

/** @param arrives whether motion values arrived; `undefined` before they were checked */
export function sensorsCheck(
  access: MotionAccess,
  arrives: boolean | undefined,
  isTouch: boolean,
): Check {
  const id = 'sensors';
  const title = 'Motion sensors';
  switch (access) {
    case 'ask':
      return { id, state: 'asks', title, text: 'Tap Allow in the browser’s prompt.' };
    case 'refused':
      return {
        id,
        state: 'warning',
        title: 'Motion access was denied',
        text: 'The browser asks again only after a restart: close it completely, open it and scan again. Everything else works without motion.',
      };
    case 'insecure':
      return isTouch
        ? { id, state: 'warning', title, text: 'Off: this page uses plain HTTP.' }
        : { id, state: 'none', title, text: 'Not available on this page' };
    case 'unsupported':
    case 'granted':
      if (arrives === true) return { id, state: 'good', title, text: 'Motion works' };
      return isTouch
        ? {
            id,
            state: 'warning',
            title,
            text: 'No motion data received. The browser may block it in its site settings. Touch, buttons and text work.',
          }
        : { id, state: 'none', title, text: 'This device has no motion sensors' };
  }
}
