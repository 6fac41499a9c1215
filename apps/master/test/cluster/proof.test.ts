import { masterProofText } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { PlainTokens } from '../../src/testing/plain-tokens.ts';
import { TestMaster } from '../../src/testing/index.ts';
import { stranger } from '../access-world.ts';

const NONCE = '0f3c9a52-7d1e-4b86-9a40-5c2d8e61f7b3';

/** Asks a master with two addresses as an unknown caller. */
async function ask(question: { targetId?: string; host?: string; nonce?: string } = {}) {
  const addresses = [{ url: 'https://10.0.0.6:8080' }, { url: 'http://localhost:8080' }];
  const master = new TestMaster({ endpoints: { addresses } });
  const masterProofRequest = { targetId: 'ada', host: '10.0.0.6:8080', nonce: NONCE, ...question };
  return master.call({ topic: '/services/ubii/master_proof', masterProofRequest }, stranger());
}

function proofFor(host: string, clientId = 'ada', nonce = NONCE): string {
  return new PlainTokens().prove(clientId, masterProofText({ host, clientId, nonce }));
}

describe('the proof that a master is of a cluster [CU-85]', () => {
  it('is given to any caller, and is valid for this client, address and question only', async () => {
    expect((await ask()).masterProof?.proof).toBe(proofFor('10.0.0.6:8080'));
    expect((await ask({ host: 'localhost:8080' })).masterProof?.proof).toBe(
      proofFor('localhost:8080'),
    );
    expect((await ask({ targetId: 'ben' })).masterProof?.proof).toBe(
      proofFor('10.0.0.6:8080', 'ben'),
    );
  });

  it('is worth nothing for another address, and looks like any other', async () => {
    const { masterProof } = await ask({ host: '10.0.0.7:8080' });
    expect(masterProof?.proof).toMatch(/^[0-9a-f]{64}$/);
    expect(masterProof?.proof).not.toBe(proofFor('10.0.0.7:8080'));
  });

  it.each(['', 'short', 'x'.repeat(65), `${NONCE}\n`, `${NONCE} `, 'é'.repeat(20)])(
    'is not given for the nonce %j',
    async (nonce) => {
      const { error, masterProof } = await ask({ nonce });
      expect([error?.code, masterProof]).toEqual(['invalid_argument', undefined]);
    },
  );
});
