import { CERTIFICATE_PATH } from '../../connect-certificate/routes.ts';
import type { Platform } from '../../connection/platform.ts';
import type { MotionAccess } from '../../devices/sensors/motion-access.ts';
import type { Check } from './check.ts';
import type { ChannelProbe } from './probe-channel.ts';

/** A clock that is off by more is worth a word, milliseconds. */
const CLOCK_OFF_MS = 2000;

/** Milliseconds as people read them: `0.8 ms`, `12 ms`. */
export function formatMs(ms: number): string {
  return `${ms < 10 ? Math.max(0.1, Math.round(ms * 10) / 10) : Math.round(ms)} ms`;
}

/** @param tripMs `undefined` when no answer came */
export function masterCheck(tripMs: number | undefined, page: URL): Check {
  const { hostname, port, protocol } = page;
  const id = 'master';
  if (tripMs !== undefined) {
    return {
      id,
      state: 'good',
      title: 'Master reached',
      text: `${hostname}, port ${port || (protocol === 'https:' ? '443' : '80')}`,
      value: formatMs(tripMs),
    };
  }
  const name = hostname.endsWith('.local')
    ? ' Many Android phones, and all behind a VPN, do not find names that end in .local: open the address in numbers on the host’s screen.'
    : '';
  return {
    id,
    state: 'failed',
    title: 'Master not reached',
    text: `${hostname} does not answer.${name} Is this device in the same Wi-Fi as the host, with mobile data and VPN off? Guest networks often keep devices apart (client isolation): use another network or a hotspot. On the host, a firewall may close port ${port || '443'}, or the master has stopped.`,
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
      text: 'The master runs on this machine',
      value: 'local',
    };
  }
  return {
    id,
    state: 'warning',
    title: 'Plain HTTP',
    text: 'Browsers give motion sensors, camera and microphone to secure pages only. The secure page shows a warning about its certificate first: choose to go on, or install the certificate.',
    value: 'HTTP',
    remedy: { text: 'Open the secure page', href: securePage(page) },
  };
}

/** The same page over HTTPS, which the master answers on the same port. */
export function securePage(page: URL): string {
  const secure = new URL(page);
  secure.protocol = 'https:';
  return secure.href;
}

/** @param probe `undefined` when the master is not reached: nothing can be told then */
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
      title: 'Live channel',
      text: 'Cannot be tried before the master is reached.',
    };
  }
  if (probe.isOpen) {
    return {
      id,
      state: 'good',
      title: 'Live channel',
      text: 'Open both ways',
      value: formatMs(probe.roundTripMs),
    };
  }
  const title = 'Live channel blocked';
  if (platform === 'ios' && page.protocol === 'https:') {
    return {
      id,
      state: 'failed',
      title,
      text: 'The page came through, its WebSocket did not. iOS often refuses it while the certificate was only accepted, not installed. Install the certificate and switch on full trust for it.',
      remedy: { text: 'Install the certificate', href: CERTIFICATE_PATH },
    };
  }
  return {
    id,
    state: 'failed',
    title,
    text:
      probe.reason === 'silent'
        ? 'The WebSocket opened too slowly or carries nothing. A proxy or VPN holds it back: switch it off for this network, or use another.'
        : 'The page came through, its WebSocket did not. A proxy, VPN, content blocker or security app lets only pages pass: switch it off for this address, or use another browser or network.',
    ...(page.protocol === 'https:'
      ? { remedy: { text: 'Install the certificate', href: CERTIFICATE_PATH } }
      : {}),
  };
}

export function clockCheck(probe: ChannelProbe | undefined): Check {
  const id = 'clock';
  const title = 'Clock';
  if (probe === undefined || !probe.isOpen) {
    return { id, state: 'none', title, text: 'Compared over the live channel' };
  }
  const { offsetMs, errorMs } = probe;
  const value = `±${formatMs(errorMs)}`;
  if (Math.abs(offsetMs) <= CLOCK_OFF_MS) {
    return { id, state: 'good', title, text: 'Matched to the master', value };
  }
  const seconds = Math.round(Math.abs(offsetMs) / 1000);
  const off = seconds < 120 ? `${seconds} s` : `${Math.round(seconds / 60)} min`;
  return {
    id,
    state: 'warning',
    title,
    text: `${off} ${offsetMs > 0 ? 'behind' : 'ahead of'} the master. Times on this device look wrong until its clock is set; nothing else changes.`,
    value,
  };
}

/** @param arrives whether motion values came; `undefined` while nobody has waited for them */
export function sensorsCheck(
  access: MotionAccess,
  arrives: boolean | undefined,
  isTouch: boolean,
): Check {
  const id = 'sensors';
  const title = 'Motion sensors';
  switch (access) {
    case 'ask':
      return { id, state: 'asks', title, text: 'The phone asks once. Say Allow.' };
    case 'refused':
      return {
        id,
        state: 'warning',
        title: 'Motion was refused',
        text: 'The browser asks again only after it was closed completely: swipe it away, open it and scan again. Everything else works without.',
      };
    case 'insecure':
      return isTouch
        ? { id, state: 'warning', title, text: 'Off, because this page is plain HTTP.' }
        : { id, state: 'none', title, text: 'Not on this page' };
    case 'unsupported':
    case 'granted':
      if (arrives === true) return { id, state: 'good', title, text: 'Motion arrives' };
      return isTouch
        ? {
            id,
            state: 'warning',
            title,
            text: 'No motion arrives. The browser may block it in its site settings. Touch, buttons and text work.',
          }
        : { id, state: 'none', title, text: 'This device has none' };
  }
}
