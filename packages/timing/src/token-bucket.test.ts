import { describe, expect, it } from 'vitest';
import { TokenBucket } from './token-bucket.ts';

describe('TokenBucket', () => {
  it('gives at once what grows in a second, and then as it grows', () => {
    const bucket = new TokenBucket(10, 0);
    expect(Array.from({ length: 11 }, () => bucket.take(1, 0)).filter(Boolean)).toHaveLength(10);
    expect(bucket.take(1, 99)).toBe(false);
    expect(bucket.take(1, 100)).toBe(true);
    expect(bucket.take(1, 100)).toBe(false);
  });

  it('holds no more after a long time than at the beginning', () => {
    const bucket = new TokenBucket(10, 0);
    expect(bucket.take(11, 1_000_000)).toBe(false);
    expect(bucket.take(10, 1_000_000)).toBe(true);
  });

  it('takes nothing when there is not enough', () => {
    const bucket = new TokenBucket(10, 0);
    expect(bucket.take(11, 0)).toBe(false);
    expect(bucket.take(10, 0)).toBe(true);
  });

  it('can go into debt for what is spent already, and grows out of it', () => {
    const bucket = new TokenBucket(50, 0, 500);
    expect(bucket.spend(499, 0)).toBe(true);
    expect(bucket.spend(101, 0)).toBe(false);
    expect(bucket.spend(0, 2_000)).toBe(false);
    expect(bucket.spend(0, 2_001)).toBe(true);
  });

  it('tells what is left without taking it', () => {
    const bucket = new TokenBucket(10, 0);
    expect(bucket.has(10, 0)).toBe(true);
    expect(bucket.take(10, 0)).toBe(true);
    expect(bucket.has(1, 99)).toBe(false);
    expect(bucket.has(1, 100)).toBe(true);
  });

  it('tells how long to wait until debt is paid', () => {
    const bucket = new TokenBucket(10, 0);
    expect(bucket.waitMs(0)).toBe(0);
    bucket.spend(12, 0);
    expect(bucket.waitMs(0)).toBe(200);
    bucket.spend(0, 200);
    expect(bucket.waitMs(200)).toBe(1);
    expect(bucket.waitMs(201)).toBe(0);
  });
});
