import { createHmac } from 'node:crypto';
import type { ResumeTokens } from '../core/ports/resume-tokens.ts';

/** Predictable tokens for tests: the id with a prefix. */
export class PlainTokens implements ResumeTokens {
  issue(clientId: string): string {
    return `token-of-${clientId}`;
  }

  verify(clientId: string, token: string): boolean {
    return token === this.issue(clientId);
  }

  prove(clientId: string, text: string): string {
    return createHmac('sha256', this.issue(clientId)).update(text).digest('hex');
  }
}
