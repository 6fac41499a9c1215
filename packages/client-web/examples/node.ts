// A program that comes back as the same client when it is started again.
// Run: node --import tsx examples/node.ts [url] [file], twice
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createClient } from '@ubii/client-web/node';
import type { Identity, IdentityStorage } from '@ubii/client-web/node';

const file = process.argv[3] ?? 'identity.json';

// The resume token is a secret: a program that has it can connect as this client.
const identity: IdentityStorage = {
  load() {
    try {
      return JSON.parse(readFileSync(file, 'utf8')) as Identity;
    } catch {
      return undefined; // the first start
    }
  },
  save(next) {
    if (next === undefined) rmSync(file, { force: true });
    else writeFileSync(file, JSON.stringify(next), { mode: 0o600 });
  },
};

const client = createClient({
  url: process.argv[2] ?? 'http://localhost:8080',
  name: 'robot',
  identity,
  reconnect: { giveUpAfterAttempts: 5 }, // the service manager takes over then
});
await client.connect();

const { state } = client;
if (state.status === 'connected') {
  console.log(`${state.resumed ? 'again' : 'for the first time'}: ${state.clientId}`);
}

// Not close(): that deregisters, and the identity ends with it.
process.exit();
