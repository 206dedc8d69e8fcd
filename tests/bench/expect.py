# SPDX-License-Identifier: MIT
"""What the self-test is made of."""

import image as images


def must(true, what):
    if not true:
        raise images.Failure(f"self-test: {what}")


def refuses(action, what, because=""):
    try:
        action()
    except images.Failure as failure:
        must(because in str(failure), f"{what} is refused because of: {failure}")
        return
    raise images.Failure(f"self-test: {what} is not refused")
