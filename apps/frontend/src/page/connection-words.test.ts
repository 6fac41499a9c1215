import { ConnectionError, type ConnectionState } from '@ubii/client-web';
import { describe, expect, it } from 'vitest';
import { connectionNotice, connectionWord } from './connection-words.ts';

const NOW = 1_000_000;
const connected: ConnectionState = {
  status: 'connected',
  clientId: 'c',
  resumed: false,
  masterVersion: '0.1.0',
  sinceMs: NOW,
};
const closed = (reason: ConnectionError['reason']): ConnectionState => ({
  status: 'closed',
  error: new ConnectionError(reason, 'Because.'),
});

describe('connectionNotice', () => {
  it('is silent while all is well or still starting', () => {
    expect(connectionNotice({ status: 'idle' }, NOW, false)).toBeUndefined();
    expect(connectionNotice({ status: 'connecting', attempt: 1 }, NOW, false)).toBeUndefined();
    expect(connectionNotice(connected, NOW, true)).toBeUndefined();
  });

  it('says what was lost, what is retried and when', () => {
    const state: ConnectionState = {
      status: 'reconnecting',
      attempt: 4,
      nextAttemptMs: NOW + 2400,
      error: new ConnectionError('refused', 'The master is down.'),
    };
    expect(connectionNotice(state, NOW, true)).toEqual({
      tone: 'warning',
      text: 'Ubi-Interact cannot be reached. The page shows the last values that it received.',
      next: 'Retry in 3 s, try 4',
      action: 'Retry now',
    });
    const lost = { ...state, attempt: 8 };
    expect(connectionNotice(state, NOW, false, ['http://b'])?.text).not.toContain('other');
    expect(connectionNotice(lost, NOW, false, ['http://b'])?.text).toBe(
      'Ubi-Interact cannot be reached. The other computers of the cluster cannot be reached either.',
    );
    expect(connectionNotice(lost, NOW, false, ['https://b'])?.text).toMatch(
      /Over HTTPS, this device has to trust the certificate of each computer\.$/, // [CU-93]
    );
    expect(connectionNotice(state, NOW + 2400, false)).toMatchObject({
      text: 'Ubi-Interact cannot be reached.',
      next: 'Retrying, try 4',
    });
  });

  it('offers to take the place back when another tab took it', () => {
    expect(connectionNotice(closed('superseded'), NOW, true)).toMatchObject({
      tone: 'stopped',
      action: 'Use this tab',
    });
  });

  it('names the client that disconnected this page, and offers to reconnect', () => {
    const error = new ConnectionError(
      'disconnected',
      'This client was disconnected by Mara: too loud',
    );
    expect(connectionNotice({ status: 'closed', error }, NOW, true)).toMatchObject({
      tone: 'stopped',
      text: 'This page was disconnected by Mara: too loud',
      action: 'Connect',
    });
  });

  it('says that nothing is retried after a terminal failure', () => {
    expect(connectionNotice(closed('protocol'), NOW, true)).toMatchObject({
      tone: 'error',
      next: 'Because.',
    });
  });
});

it('every state has a mark and a word', () => {
  expect(connectionWord(connected)).toEqual({ mark: 'live', text: 'Connected' });
  expect(connectionWord(closed('superseded')).text).toBe('In use elsewhere');
  expect(connectionWord(closed('timeout')).mark).toBe('error');
});
