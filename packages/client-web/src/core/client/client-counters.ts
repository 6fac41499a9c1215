/** Totals since the client was created. */
export interface ClientCounters {
  /** Records received, as the master sent them. */
  readonly recordsIn: number;
  /** Records handed to the socket. */
  readonly recordsOut: number;
  /** Bytes of topic-data frames received. */
  readonly bytesIn: number;
  /** Bytes of topic-data frames sent. */
  readonly bytesOut: number;
  /** Published records that were not sent: replaced by newer ones, or over a limit, while the socket was full or away. */
  readonly recordsDropped: number;
  /** Records and frames of the master that could not be decoded. */
  readonly decodeErrors: number;
}
