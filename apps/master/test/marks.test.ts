import { AccessRole, type Client, type Mark } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { createGrant, stranger } from './access-world.ts';

const { ACCESS_ROLE_PLAYER } = AccessRole;

/** A master with an invitation for phones. */
async function createRoom() {
  const master = new TestMaster();
  const { token } = await createGrant(master, ACCESS_ROLE_PLAYER);
  const check = async () => {
    const reply = await master.call(
      { topic: '/services/ubii/join_check', joinCheckRequest: { token } },
      stranger(''),
    );
    return reply.joinCheck!;
  };
  const join = async (name: string, mark?: Mark): Promise<Client> => {
    const reply = await master.call(
      {
        topic: '/services/client/registration',
        client: { name, extension: mark === undefined ? {} : { mark } },
      },
      stranger(token),
    );
    return reply.client!;
  };
  const list = async () => (await master.call({ topic: '/services/client/get_list' })).clientList!;
  return { master, check, join, list };
}

describe('marks of clients [EX-100]', () => {
  it('differ for two phones that were proposed the same one', async () => {
    const { check, join, list } = await createRoom();
    const [first, second] = [await check(), await check()];
    const mara = await join('Mara', first.freeMark);
    const theo = await join('Theo', second.freeMark);
    expect(mara.extension?.mark).toMatchObject({ shape: 1, colour: 1 });
    expect(theo.extension?.mark).toMatchObject({ shape: 2, colour: 2 });
    const marks = (await list()).elements.map(({ extension }) => extension?.mark);
    expect(marks).toEqual([mara.extension?.mark, theo.extension?.mark]);
  });

  it('are told to who joins, with the next free one', async () => {
    const { check, join } = await createRoom();
    await join('Mara');
    const { freeMark, takenMarks } = await check();
    expect(freeMark).toMatchObject({ shape: 2, colour: 2 });
    expect(takenMarks).toMatchObject([{ name: 'Mara', mark: { shape: 1, colour: 1 } }]);
  });

  it('are what a person chose, also when another client has it', async () => {
    const { join } = await createRoom();
    const chosen: Mark = { shape: 3, colour: 5, chosen: true };
    expect((await join('Mara', chosen)).extension?.mark).toEqual(chosen);
    expect((await join('Theo', chosen)).extension?.mark).toEqual(chosen);
  });
});
