// The viewer's own style sheet. Constructed, so a strict CSP has nothing to say about it.
import { css } from 'lit';

export const styles = css`
  :host {
    display: inline-block;
    position: relative;
    width: 300px;
    height: 150px;
    overflow: hidden;
    contain: strict;
  }

  :host([hidden]) {
    display: none;
  }

  .surface,
  .holder,
  .poster,
  .message {
    position: absolute;
    inset: 0;
  }

  .holder {
    transition: visibility 1ms; /* its events tell when the page hides or shows the picture by this property */
  }

  .surface {
    cursor: grab;
    outline: none;
    touch-action: pan-y;
    user-select: none;
    -webkit-user-select: none;
  }

  .surface:active {
    cursor: grabbing;
  }

  .surface.fixed {
    cursor: default;
  }

  .surface:focus-visible::after {
    content: '';
    position: absolute;
    inset: 0;
    border: 2px solid Highlight;
    pointer-events: none;
  }

  canvas {
    display: block;
    width: 100%;
    height: 100%;
  }

  .poster {
    width: 100%;
    height: 100%;
    object-fit: contain;
    pointer-events: none;
  }

  .message {
    display: grid;
    place-items: center;
    pointer-events: none;
  }

  .message > * {
    pointer-events: auto;
  }

  .notice {
    box-sizing: border-box;
    max-width: 90%;
    margin: 0;
    padding: 0.5em 0.75em;
    border-radius: 0.375em;
    background: #2b1d1d;
    color: #ffe3e0;
    font:
      0.875rem/1.4 system-ui,
      sans-serif;
    overflow-wrap: anywhere;
  }

  .panel {
    position: absolute;
    top: 0;
    right: 0;
    max-width: 100%;
    max-height: 100%;
    overflow: hidden auto;
    overscroll-behavior: contain;
  }

  slot:not([name]) {
    display: none;
  }
`;
