import { AccessRole } from '@ubii/proto';
import { createMemoryIdentity } from '@ubii/client-web/node';
import type { Identity, IdentityStorage } from '@ubii/client-web/node';
import { describe, expect, it } from 'vitest';
import { createGrant, revoke } from './access-world.ts';
import { ClientWorld } from './client-world.ts';

const { ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER, ACCESS_ROLE_VIEWER } = AccessRole;

/** The storage of a browser: an identity for each tab, one credential for all of them. */
class Browser {
  credential: string | undefined;

  tab(identity?: Identity): IdentityStorage {
    const own = createMemoryIdentity(identity);
    return {
      load: () => own.load(),
      save: (next) => {
        own.save(next);
        this.credential = next?.credential ?? this.credential;
      },
      loadCredential: () => this.credential,
      forgetCredential: (credential) => {
        if (this.credential === credential) this.credential = undefined;
      },
    };
  }
}

async function setup(role: AccessRole = ACCESS_ROLE_PLAYER, maxJoins = 0) {
  const world = new ClientWorld();
  const created = await createGrant(world.test, role, { maxJoins });
  world.standing = 'other';
  return { world, ...created };
}

const joinError = (joinProblem: string) => ({
  status: 'closed',
  error: { reason: 'join', joinProblem },
});

describe('a client of ours that has to join', () => {
  it('says so, and why, once and for all [AC-12]', async () => {
    const { world, token, grant } = await setup();
    const alone = world.connect('ada');
    await expect(alone).rejects.toMatchObject({ reason: 'join', joinProblem: 'missing' });
    for (const wrong of ['x'.repeat(43), 'nonsense', 'über', '', 'a\nb']) {
      const tried = world.connect('ada', { joinToken: wrong });
      await expect(tried).rejects.toMatchObject({ reason: 'join', joinProblem: 'wrong' });
    }
    await revoke(world.test, grant!.id);
    const late = world.connect('ada', { joinToken: token });
    await expect(late).rejects.toMatchObject({ reason: 'join', joinProblem: 'revoked' });
  });

  it('is in with a token, as what it says, and calls and publishes [AC-13] [AC-20]', async () => {
    const { world, token } = await setup(ACCESS_ROLE_VIEWER);
    const { client, states } = await world.connect('ada', { joinToken: token });
    expect(client.role).toBe('viewer');
    expect(states.at(-1)?.status).toBe('connected');
    const call = client.call('clientGetList', {});
    await world.pass(0);
    expect((await call).elements).toHaveLength(1);
  });

  it('is deregistered when it closes [CL-16]', async () => {
    const { world, token } = await setup();
    const { client } = await world.connect('ada', { joinToken: token });
    await Promise.all([client.close(), world.pass(5_000)]);
    world.standing = 'trusted';
    const admin = await world.connect('admin');
    const called = admin.client.call('clientGetList', {});
    await world.pass(0);
    expect((await called).elements.map(({ name }) => name)).toEqual(['admin']);
  });

  it('joins when it gets a code later, and again with another role [AC-11]', async () => {
    const { world, code } = await setup(ACCESS_ROLE_PLAYER);
    world.standing = 'trusted';
    const participants = await createGrant(world.test, ACCESS_ROLE_PARTICIPANT);
    world.standing = 'other';
    const { client, states } = await world
      .connect('ada', { joinToken: 'nonsense' })
      .catch(() => world.connect('ada', { joinToken: code.toLowerCase() }));
    const { id } = client;
    expect(client.role).toBe('player');
    const joined = client.join(participants.token);
    await world.pass(0);
    await joined;
    expect([client.role, client.id]).toEqual(['participant', id]);
    const wrong = client.join('nonsense');
    wrong.catch(() => undefined);
    await world.pass(0);
    await expect(wrong).rejects.toMatchObject({ joinProblem: 'wrong' });
    expect([client.role, client.state.status]).toEqual(['participant', 'connected']);
    await world.drop();
    await world.pass(2_000);
    expect([client.role, client.id]).toEqual(['participant', id]);
    expect(states.filter(({ status }) => status === 'closed')).toEqual([]);
  });

  it('joins while an attempt without the token is under way', async () => {
    const { world, token } = await setup();
    const { client } = await world.connect('x', { joinToken: token });
    await Promise.all([client.close(), world.pass(0)]);
    const trying = client.connect();
    trying.catch(() => undefined);
    const joined = client.join(token);
    await world.pass(0);
    await joined;
    expect([client.state.status, client.role]).toEqual(['connected', 'player']);
  });

  it('stays in through a broken link and a restart of the master, with id and role [AC-23]', async () => {
    const { world, token } = await setup(ACCESS_ROLE_PLAYER, 1);
    const { client } = await world.connect('ada', { joinToken: token });
    const { id } = client;
    await world.drop();
    await world.pass(2_000);
    expect([client.state.status, client.id, client.role]).toEqual(['connected', id, 'player']);
    await world.restart();
    await world.pass(2_000);
    expect([client.state.status, client.id, client.role]).toEqual(['connected', id, 'player']);
  });

  it('comes back as itself after a reload, and brings a second tab along [AC-18] [AC-23]', async () => {
    const { world, token } = await setup(ACCESS_ROLE_PLAYER, 1);
    const browser = new Browser();
    let kept: Identity | undefined;
    const storage = browser.tab();
    const first = await world.connect('ada', {
      joinToken: token,
      identity: { ...storage, save: (next) => storage.save((kept = next)) },
    });
    const tab = await world.connect('tab', { identity: browser.tab() });
    expect(tab.client.id).not.toBe(first.client.id);
    expect(tab.client.role).toBe('player');
    // The old link is opened once more.
    const earlier = kept;
    await Promise.all([first.client.close(), world.pass(0)]);
    const again = await world.connect('ada', { joinToken: token, identity: browser.tab(earlier) });
    expect(again.client.id).toBe(first.client.id);
    expect(again.client.role).toBe('player');
  });

  it('is told when its leave is revoked, and forgets it [AC-15]', async () => {
    const { world, token, grant } = await setup();
    const browser = new Browser();
    const { client } = await world.connect('ada', { joinToken: token, identity: browser.tab() });
    await revoke(world.test, grant!.id, 'the class is over');
    await world.pass(60_000);
    expect(client.state).toMatchObject(joinError('revoked'));
    expect(client.state).toMatchObject({
      error: { message: expect.stringContaining('the class is over') as string },
    });
    const again = world.connect('ada', { identity: browser.tab() });
    await expect(again).rejects.toMatchObject({ reason: 'join', joinProblem: 'revoked' });
    expect(browser.credential).toBeUndefined();
  });

  it('is told when its time is over, and forgets what it joined with [AC-91] [EX-5]', async () => {
    const { world } = await setup();
    world.standing = 'trusted';
    const { token } = await createGrant(world.test, ACCESS_ROLE_PLAYER, { lifetimeMs: 60_000 });
    world.standing = 'other';
    const browser = new Browser();
    const { client } = await world.connect('ada', { joinToken: token, identity: browser.tab() });
    expect(browser.credential).toBeDefined();
    await world.pass(50_000);
    expect(client.state.status).toBe('connected');
    await world.pass(15_000);
    expect(client.state).toMatchObject(joinError('expired'));
    const again = world.connect('ada', { identity: browser.tab() });
    await expect(again).rejects.toMatchObject({ reason: 'join', joinProblem: 'expired' });
    expect(browser.credential).toBeUndefined();
  });

  it('is an admin on the machine of the master, whatever it was given elsewhere [AC-2]', async () => {
    const world = new ClientWorld();
    const browser = new Browser();
    browser.credential = 'u1.of.another.0.master';
    const { client } = await world.connect('ada', { identity: browser.tab() });
    expect(client.role).toBe('admin');
    expect(browser.credential).toBeUndefined();
  });

  it('hears from services why its sockets are refused [AC-27]', async () => {
    const { world, token, grant } = await setup();
    const { client } = await world.connect('ada', { joinToken: token });
    const open = world.openConnection.bind(world);
    world.openConnection = () => undefined;
    await world.drop();
    await world.pass(1_000);
    expect(client.state.status).toBe('reconnecting');
    await revoke(world.test, grant!.id);
    await world.pass(10_000);
    world.openConnection = open;
    expect(client.state).toMatchObject(joinError('revoked'));
  });
});
