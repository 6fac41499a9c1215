import { describe, expect, it } from 'vitest';
import {
  OPENED,
  type CheckReply,
  type JoinEffect,
  type JoinEvent,
  type JoinState,
  type Situation,
} from './join-state.ts';
import { joinStep } from './join-step.ts';

const STRANGER: Situation = {
  token: 'ABCD-EFGH',
  wantsAnother: false,
  isThisMachine: false,
  connection: 'other',
};
const PLAYER: CheckReply = {
  masterName: 'Workshop',
  role: 'player',
  problem: undefined,
  target: '/devices',
  isJoined: false,
  marks: { free: { shape: 1, colour: 1, chosen: false }, taken: [] },
};

/** Creates a page in a situation that tests can change. */
function openPage(changes: Partial<Situation> = {}) {
  let state: JoinState = OPENED;
  let situation: Situation = { ...STRANGER, ...changes };
  const effects: JoinEffect[] = [];
  const dispatch = (event: JoinEvent): JoinEffect[] => {
    const step = joinStep(state, event, situation);
    state = step.state;
    effects.push(...step.effects);
    return [...step.effects];
  };
  const page = {
    get state() {
      return state;
    },
    effects,
    dispatch,
    check: () => dispatch({ type: 'check', token: situation.token }),
    /** Replies to the newest check. */
    reply: (changes: Partial<CheckReply> = {}) => {
      const check = effects
        .flatMap((effect) => (effect.type === 'check' ? effect.check : []))
        .at(-1)!;
      return dispatch({ type: 'checked', check, reply: { ...PLAYER, ...changes } });
    },
    change: (changes: Partial<Situation>) => {
      situation = { ...situation, ...changes };
      return dispatch({ type: 'connection' });
    },
  };
  page.check();
  return page;
}

const leaves = (effects: readonly JoinEffect[]) => effects.some(({ type }) => type === 'leave');

describe('a device that comes with a code', () => {
  it('checks it as a stranger, and is one tap away', () => {
    const page = openPage();
    expect(page.state.phase).toBe('asking');
    page.reply();
    expect(page.state).toMatchObject({ phase: 'ready', masterName: 'Workshop' });
    expect(page.dispatch({ type: 'join' })).toEqual([{ type: 'join', token: 'ABCD-EFGH' }]);
    expect(page.state.phase).toBe('joining');
    expect(page.dispatch({ type: 'join' })).toEqual([]);
    expect(leaves(page.change({ connection: 'connected', role: 'player' }))).toBe(true);
  });

  it('counts only the reply to the newest check', () => {
    const page = openPage();
    const [, first] = page.effects;
    page.check();
    if (first?.type !== 'check') throw new Error('nothing was checked');
    page.dispatch({ type: 'unanswered', check: first.check, message: 'gone' });
    page.dispatch({ type: 'checked', check: first.check, reply: PLAYER });
    expect(page.state.phase).toBe('asking');
    page.reply();
    expect(page.state.phase).toBe('ready');
  });

  it('types another code when this one is not valid', () => {
    const page = openPage();
    page.reply({ role: undefined, problem: 'expired' });
    expect(page.state).toMatchObject({ phase: 'code', problem: 'expired' });
  });

  it('is asked again while others guess, and the page stays', () => {
    const page = openPage();
    const again = { type: 'check', token: 'ABCD-EFGH' } as const;
    const effects = page.reply({ role: undefined, problem: 'guessing' });
    expect(effects).toEqual([{ type: 'later', afterMs: 1000, event: again }]);
    page.dispatch(again);
    expect(page.state).toMatchObject({ phase: 'code', problem: 'guessing' });
  });

  it('is asked again when the master does not answer', () => {
    const page = openPage();
    const check = { number: 1, token: 'ABCD-EFGH', asClient: false };
    const effects = page.dispatch({ type: 'unanswered', check, message: 'No answer' });
    expect(effects).toEqual([
      { type: 'later', afterMs: 3000, event: { type: 'check', token: 'ABCD-EFGH' } },
    ]);
    page.check();
    expect(page.state).toMatchObject({ phase: 'unreachable', trouble: '' });
  });
});

describe('joining', () => {
  function joiningPage(changes: Partial<Situation> = {}) {
    const page = openPage(changes);
    page.reply();
    page.dispatch({ type: 'join' });
    return page;
  }

  it('that fails can be tried again, and says why it failed', () => {
    const page = joiningPage();
    page.dispatch({ type: 'failed', message: 'The channel does not open' });
    expect(page.state).toMatchObject({ phase: 'ready', trouble: 'The channel does not open' });
    page.dispatch({ type: 'join' });
    expect(page.state).toMatchObject({ phase: 'joining', trouble: '' });
  });

  it('with a code that is used up meanwhile asks for another one', () => {
    const page = joiningPage();
    page.dispatch({ type: 'refused', problem: 'used' });
    expect(page.state).toMatchObject({ phase: 'code', problem: 'used', invitation: undefined });
  });

  it('continues by itself when the guessing of others ends', () => {
    const page = joiningPage();
    const effects = page.dispatch({ type: 'refused', problem: 'guessing' });
    expect(effects).toEqual([{ type: 'later', afterMs: 1000, event: { type: 'join-again' } }]);
    expect(page.state.phase).toBe('joining');
    const again = page.dispatch({ type: 'join-again' });
    expect(again).toEqual([{ type: 'join', token: 'ABCD-EFGH' }]);
    expect(page.state.trouble).toContain('keeps retrying');
  });

  it('only waits for the channel of a client that has registered', () => {
    const page = openPage({ connection: 'reconnecting', role: 'player' });
    page.reply();
    expect(page.dispatch({ type: 'join' })).toEqual([{ type: 'reconnect' }]);
  });

  it('ignores what it hears once the page is being left', () => {
    const page = joiningPage();
    page.change({ connection: 'connected', role: 'player' });
    expect(page.dispatch({ type: 'failed', message: 'late' })).toEqual([]);
    expect(page.state).toMatchObject({ isLeaving: true, trouble: '' });
  });
});

describe('a client that is connected', () => {
  it('leaves at once without a code', () => {
    const page = openPage({ token: '', connection: 'connected', role: 'participant' });
    expect(leaves(page.effects)).toBe(true);
  });

  it('joins with the code of another grant by a tap, and leaves when the master has admitted it', () => {
    const page = openPage({ connection: 'connected', role: 'viewer' });
    page.reply();
    expect(page.state.phase).toBe('ready');
    page.dispatch({ type: 'join' });
    expect(leaves(page.change({}))).toBe(false);
    expect(leaves(page.dispatch({ type: 'joined' }))).toBe(true);
  });

  it('leaves when it has joined with this code before', () => {
    const page = openPage({ connection: 'connected', role: 'player' });
    expect(leaves(page.reply({ isJoined: true }))).toBe(true);
  });

  it('is asked about as a client when the channel came after the reply', () => {
    const page = openPage();
    page.reply({ role: undefined, problem: 'used' });
    const effects = page.change({ connection: 'connected', role: 'player' });
    const check = { number: 2, token: 'ABCD-EFGH', asClient: true };
    expect(effects).toContainEqual({ type: 'check', check });
    expect(leaves(page.reply({ isJoined: true }))).toBe(true);
  });

  it('becomes an admin on the machine of the master without a tap, and the page says so', () => {
    const page = openPage({
      connection: 'connected',
      isThisMachine: true,
      role: 'participant',
      wantsAnother: true,
    });
    expect(page.reply({ role: 'admin' })).toEqual([{ type: 'join', token: 'ABCD-EFGH' }]);
    page.dispatch({ type: 'failed', message: 'No channel' });
    expect(page.state.phase).toBe('ready');
    page.dispatch({ type: 'join' });
    const effects = page.change({ role: 'admin' });
    expect(effects).toEqual([{ type: 'leave', becameAdmin: true }]);
  });
});

describe('a device that comes without a code', () => {
  it('shows why it was sent here, once that is known', () => {
    const page = openPage({ token: '' });
    page.reply({ role: undefined, problem: 'missing' });
    expect(page.state.phase).toBe('asking');
    page.change({ connection: 'closed', refusal: 'revoked' });
    expect(page.state).toMatchObject({ phase: 'code', problem: 'revoked' });
  });

  it('enters one when it wants to', () => {
    const page = openPage({
      token: '',
      wantsAnother: true,
      connection: 'connected',
      role: 'viewer',
    });
    page.reply({ role: undefined, problem: 'missing' });
    expect(page.state).toMatchObject({ phase: 'code', problem: 'missing' });
    expect(page.dispatch({ type: 'leave' })).toEqual([{ type: 'leave', becameAdmin: false }]);
  });
});
