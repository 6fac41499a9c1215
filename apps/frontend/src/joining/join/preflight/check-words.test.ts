import { describe, expect, it } from 'vitest';
import {
  channelCheck,
  clockCheck,
  formatMs,
  masterCheck,
  secureCheck,
  sensorsCheck,
} from './check-words.ts';
import type { ChannelProbe } from './probe-channel.ts';

const https = new URL('https://10.0.0.2:8080/join#t');
const http = new URL('http://10.0.0.2:8080/join#t');
const open: ChannelProbe = { isOpen: true, roundTripMs: 12.3, offsetMs: 40, errorMs: 0.8 };
const refused: ChannelProbe = { isOpen: false, reason: 'refused' };

describe('what a preflight found, in words [AC-30]', () => {
  it('names where the master was reached, and why it may not be', () => {
    expect(masterCheck(9.2, https)).toMatchObject({
      state: 'good',
      text: '10.0.0.2, port 8080',
      value: '9.2 ms',
    });
    const away = masterCheck(undefined, http);
    expect(away.state).toBe('failed');
    for (const cause of ['Wi-Fi', 'VPN', 'client isolation', 'firewall', 'stopped']) {
      expect(away.text).toContain(cause);
    }
    expect(away.text).not.toContain('.local');
    const byName = masterCheck(undefined, new URL('https://studio.local:8080/join#t'));
    expect(byName.text).toContain('open the numeric address');
  });

  it('leads from plain HTTP to the secure page, with the token', () => {
    expect(secureCheck(false, http)).toMatchObject({
      state: 'warning',
      remedy: { href: https.href },
    });
    expect(secureCheck(true, https).state).toBe('good');
    expect(secureCheck(true, new URL('http://localhost:8080/')).state).toBe('good');
  });

  it('knows what blocks a live channel on which system', () => {
    expect(channelCheck(open, 'ios', https)).toMatchObject({ state: 'good', value: '12 ms' });
    expect(channelCheck(refused, 'ios', https)).toMatchObject({
      state: 'failed',
      remedy: { href: '/connect/certificate' },
    });
    expect(channelCheck(refused, 'ios', http).text).toContain('proxy');
    expect(channelCheck({ isOpen: false, reason: 'silent' }, 'android', http).text).toContain(
      'VPN',
    );
    expect(channelCheck(undefined, 'android', http).text).toContain('a connection to the host');
  });

  it('tells a clock that is off, and says nothing of one it could not compare', () => {
    expect(clockCheck(open)).toMatchObject({ state: 'good', value: '±0.8 ms' });
    expect(clockCheck({ ...open, offsetMs: 3000 }).text).toContain('3 s behind');
    expect(clockCheck({ ...open, offsetMs: -300_000 }).text).toContain('5 min ahead of');
    expect(clockCheck(refused).state).toBe('none');
  });

  it('asks for motion where the platform does, and misses it on phones only', () => {
    expect(sensorsCheck('ask', undefined, true).state).toBe('asks');
    expect(sensorsCheck('refused', undefined, true).text).toContain('close it completely');
    expect(sensorsCheck('insecure', undefined, true).state).toBe('warning');
    expect(sensorsCheck('granted', true, true).state).toBe('good');
    expect(sensorsCheck('granted', false, true).state).toBe('warning');
    expect(sensorsCheck('granted', false, false).state).toBe('none');
  });
});

it('milliseconds are never nothing', () => {
  expect([0, 0.84, 9.96, 12.4].map(formatMs)).toEqual(['0.1 ms', '0.8 ms', '10 ms', '12 ms']);
});
