import { describe } from 'vitest';
import { accessSecretsSuite } from '../../testing/acceptance/index.ts';
import { HmacAccessSecrets } from './hmac-access-secrets.ts';

describe('secrets made with HMAC-SHA-256', () => {
  accessSecretsSuite((key) => new HmacAccessSecrets(Buffer.alloc(32, key)));
});
