import { masterProofText, type MessageTypes } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { ConnectionError } from './connection-error.ts';
import { askForProof, proofOf } from './master-proof.ts';

type Question = MessageTypes['ubii.extension.MasterProofRequest'];

const URL = 'http://10.0.0.6:8080';
const IDENTITY = { clientId: 'ada', resumeToken: 'secret-token' };

/** What a master of the cluster answers that has this address. */
function answerAs(host: string, token: string, { targetId, nonce }: Question): string {
  return proofOf(token, masterProofText({ host, clientId: targetId, nonce }));
}

/** Asks a server that answers like this. */
async function ask(
  answer: (question: Question) => string | Error | undefined,
  { identity = IDENTITY as typeof IDENTITY | null, url = URL, nonce = 'nonce-1' } = {},
) {
  const sent: unknown[] = [];
  const services = {
    send(request: unknown, bearer?: string) {
      sent.push([request, bearer]);
      const { masterProofRequest } = request as { masterProofRequest: Question };
      const given = answer(masterProofRequest);
      const reply =
        given instanceof Error
          ? Promise.reject(given)
          : Promise.resolve(given === undefined ? {} : { masterProof: { proof: given } });
      return { reply: reply as never, cancel: () => undefined };
    },
  };
  const topicData = { open: () => expect.unreachable() as never };
  const isProven = await askForProof({ url, services, topicData }, identity ?? undefined, nonce)
    .isProven;
  return { isProven, sent };
}

describe('the proof of another master [CU-85]', () => {
  it('is that of a master with the key of the cluster, and the question shows no secret', async () => {
    const { isProven, sent } = await ask((question) =>
      answerAs('10.0.0.6:8080', 'secret-token', question),
    );
    expect(isProven).toBe(true);
    expect(sent).toEqual([
      [
        {
          topic: '/services/ubii/master_proof',
          masterProofRequest: { targetId: 'ada', host: '10.0.0.6:8080', nonce: 'nonce-1' },
        },
        undefined,
      ],
    ]);
  });

  it.each<[string, (question: Question) => string | Error | undefined]>([
    ['another key', (question) => answerAs('10.0.0.6:8080', 'other-token', question)],
    [
      'a master at another address',
      (question) => answerAs('10.0.0.7:8080', 'secret-token', question),
    ],
    [
      'an earlier question',
      (question) => answerAs('10.0.0.6:8080', 'secret-token', { ...question, nonce: 'nonce-0' }),
    ],
    [
      'another client',
      (question) => answerAs('10.0.0.6:8080', 'secret-token', { ...question, targetId: 'ben' }),
    ],
    [
      'the beginning of it',
      (question) => answerAs('10.0.0.6:8080', 'secret-token', question).slice(0, 10),
    ],
    ['nothing', () => ''],
    ['no master', () => undefined],
    ['no server', () => new ConnectionError('refused', 'gone')],
  ])('is not that of %s', async (_, answer) => {
    expect((await ask(answer)).isProven).toBe(false);
  });

  it('is asked by those alone who have a token, and for an address', async () => {
    const answer = (question: Question) => answerAs('10.0.0.6:8080', 'secret-token', question);
    for (const options of [{ identity: null }, { url: 'nonsense' }]) {
      expect(await ask(answer, options)).toEqual({ isProven: false, sent: [] });
    }
  });

  it('is HMAC-SHA-256 in hexadecimal (RFC 4231, test case 2)', () => {
    expect(proofOf('Jefe', 'what do ya want for nothing?')).toBe(
      '5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843',
    );
  });
});
