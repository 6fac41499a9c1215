import type { ResumeTokens } from '../core/ports/resume-tokens.ts';

/** Tokens that anybody can make: the id with something in front. */
export class PlainTokens implements ResumeTokens {
  issue(clientId: string): string {
    return `token-of-${clientId}`;
  }

  verify(clientId: string, token: string): boolean {
    return token === this.issue(clientId);
  }
}
