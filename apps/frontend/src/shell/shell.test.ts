import { ConnectionError, type ConnectionState } from '@ubii/client-web';
import { describe, expect, it } from 'vitest';
import { connectionNotice, connectionWord } from './connection-words.ts';
import { modifierKey } from './modifier-key.ts';
import { isUnder } from './pages.ts';
import { matchShortcut, SHORTCUTS } from './shortcuts.ts';

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
      text: 'The master cannot be reached. The page shows the last values that it received.',
      next: 'Retry in 3 s, try 4',
      action: 'Retry now',
    });
    expect(connectionNotice(state, NOW + 2400, false)).toMatchObject({
      text: 'The master cannot be reached.',
      next: 'Retrying, try 4',
    });
  });

  it('offers to take the place back when another tab took it', () => {
    expect(connectionNotice(closed('superseded'), NOW, true)).toMatchObject({
      tone: 'stopped',
      action: 'Use this tab',
    });
  });

  it('says who disconnected this page, and offers to come back', () => {
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

describe('matchShortcut', () => {
  it('finds single keys', () => {
    expect(matchShortcut(undefined, '?').shortcut?.does).toEqual({
      kind: 'open',
      dialog: 'shortcuts',
    });
  });

  it('finds pairs, whatever the case', () => {
    const { pending } = matchShortcut(undefined, 'g');
    expect(pending).toBe('G');
    expect(matchShortcut(pending, 't').shortcut?.does).toEqual({ kind: 'go', to: '/topics' });
  });

  it('lets a key that completes no pair begin anew', () => {
    expect(matchShortcut('G', '/').shortcut?.text).toBe('Find or do anything');
    expect(matchShortcut('G', 'g')).toEqual({ pending: 'G' });
    expect(matchShortcut('G', 'Escape')).toEqual({});
  });

  it('no keys mean two things', () => {
    const keys = SHORTCUTS.map((shortcut) => shortcut.keys);
    expect(new Set(keys).size).toBe(keys.length);
  });
});

it('a page stays marked on the pages below it, Home does not', () => {
  expect(isUnder('/examples/mouse-pointer', '/examples')).toBe(true);
  expect(isUnder('/examples-of-old', '/examples')).toBe(false);
  expect(isUnder('/topics', '/')).toBe(false);
  expect(isUnder('/', '/')).toBe(true);
});

it('the modifier is called as on this machine', () => {
  expect(modifierKey('MacIntel')).toBe('⌘');
  expect(modifierKey('Linux x86_64')).toBe('Ctrl');
});
