import { describe, expect, it } from 'vitest';
import { formatCode, isWholeCode, tokenOf } from './join-code.ts';

describe('formatCode', () => {
  it('shows what is typed or pasted as codes are shown', () => {
    expect(formatCode('k7q')).toBe('K7Q');
    expect(formatCode('k7qf2')).toBe('K7QF-2');
    expect(formatCode(' k7qf 2mxr\n')).toBe('K7QF-2MXR');
    expect(formatCode('K7QF-2MXR-AND-MORE')).toBe('K7QF-2MXR');
    expect(isWholeCode('K7QF-2MXR')).toBe(true);
    expect(isWholeCode('K7QF-2MX')).toBe(false);
  });
});

describe('tokenOf', () => {
  it('finds the token of an address to join at', () => {
    expect(tokenOf('https://10.0.0.2:8080/join#abc_-1')).toBe('abc_-1');
    expect(tokenOf('#abc')).toBe('abc');
    expect(tokenOf('#%')).toBe('%');
    expect(tokenOf('K7QF-2MXR')).toBeUndefined();
    expect(tokenOf('#')).toBeUndefined();
  });
});
